#pragma once

#include "plate_impact/contact/contact.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <memory>
#include <optional>

namespace PlateImpact
{
  /// A transient from first touch on.
  struct Impact
  {
    ContactHistory history;
    double         impulse = 0.; ///< lost by the impactor [N s]

    /// In which the contact equation had a solution other than no force.
    unsigned int n_contact_steps = 0;

    /// Since when no further contact is possible; empty for plates that are
    /// free to move and schemes that do not keep energy. [s]
    std::optional<double> separation_time;
  };


  /// Newmark's method for plate and impactor and one scalar contact equation
  /// per step (eqs. 19-31 of the paper) or, with large deflections, per
  /// iteration.
  class TimeStepper
  {
  public:
    /// The plate must outlive the stepper.
    TimeStepper(const NewmarkScheme &scheme,
                SemidiscreteSystem  &plate,
                const Contact       &contact,
                const Impactor      &impactor);

    /// Of a plate whose static compliance is not known.
    TimeStepper(const NewmarkScheme         &scheme,
                std::unique_ptr<PlateMotion> plate_motion,
                const Contact               &contact,
                const Impactor              &impactor);

    /// Steps that it takes to the end time.
    unsigned int
    n_steps() const
    {
      return scheme.n_steps;
    }

    /// Takes steps.
    /// @throws ComputationError naming step and quantity when a value is not
    ///         finite or the contact equation is not solved
    void
    advance(unsigned int n_steps = 1);

    const ContactState &
    state() const
    {
      return current;
    }

    /// z, the unknowns of the plate.
    const Eigen::VectorXd &
    displacement() const
    {
      return plate_motion->unknowns();
    }

    /// So far.
    const Impact &
    impact() const
    {
      return so_far;
    }

  private:
    /// The unknown force phi of the step. [N]
    /// @param plate_free  displacement at its end without phi [m]
    double
    contact_force(double plate_free) const;
    /// Moves the impactor under phi and notes the state at the end of the step.
    void
    end_step(double phi);
    void
    require_validity() const;
    /// Whether the plate can never reach the impactor again: without a force
    /// average acceleration keeps its energy E, and the displacement under the
    /// load stays within sqrt(2 E c), c the static compliance.
    bool
    is_out_of_reach() const;

    const NewmarkScheme          scheme;
    const double                 at_begin; ///< phi there, per phi at the end
    SemidiscreteSystem          *plate = nullptr;
    std::unique_ptr<PlateMotion> plate_motion;
    Contact                      contact;
    Impactor                     impactor;
    ContactState                 current;
    Impact                       so_far;
    unsigned int                 step        = 0;
    double                       begin_force = 0.; ///< known, of the step [N]
  };



  /// All that an impactor needs to know of a plate: R_j, the displacement under
  /// the load j steps after a step with the contact force 1. Under the forces
  /// phi_k of any impactor
  ///   w_n = sum_{k <= n} R_{n-k} phi_k,
  /// a discrete Volterra equation of the second kind (Linz 1985,
  /// doi:10.1137/1.9781611970852): the recurrence of the time stepper, summed
  /// in another order. The plate's energy is the work of the force, which
  /// average acceleration makes equal.
  class PlateResponse
  {
  public:
    /// Steps the plate to the end time.
    /// @param scheme  conserves energy
    PlateResponse(const NewmarkScheme &scheme, SemidiscreteSystem &plate);

    /// R_j. [m/N]
    double
    displacement(const unsigned int j) const
    {
      return reversed[reversed.size() - 1 - j];
    }

    /// @param n_steps  at most those of the response
    /// @throws ComputationError naming step and quantity
    Impact
    impact(const Contact  &contact,
           const Impactor &impactor,
           unsigned int    n_steps) const;

  private:
    const NewmarkScheme scheme;
    Eigen::VectorXd     reversed; ///< R_{n_steps - 1} ... R_0 [m/N]
  };
} // namespace PlateImpact
