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
    /// @param plate   must outlive the stepper
    /// @param motion  null: that of the plate; with another one no separation
    ///                time is looked for
    TimeStepper(const NewmarkScheme         &scheme,
                SemidiscreteSystem          &plate,
                const Contact               &contact,
                const Impactor              &impactor,
                std::unique_ptr<PlateMotion> motion = nullptr);

    const NewmarkScheme scheme;

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
      return plate_motion->z;
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

    const double                 at_begin; ///< phi there, per phi at the end
    SemidiscreteSystem          *plate;    ///< null: for a motion of its own
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
  /// average acceleration makes equal. A motion without unknowns, at rest: who
  /// follows one under forces has a copy.
  class PlateResponse : public PlateMotion
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

    double
    begin_step(const double begin_force) override
    {
      known_force = begin_force;
      free        = forces.head(n_forces).dot(
        reversed.segment(reversed.size() - 1 - step, n_forces));
      return free;
    }

    std::optional<double>
    end_step(const double at_begin, const double at_end) override
    {
      forces[step++] = at_end;
      if (at_end != 0.)
        n_forces = step;
      const double w_end = free + displacement(0) * at_end;
      work += 0.5 * (known_force + at_begin + at_end) * (w_end - w);
      w = w_end;
      return {};
    }

    double
    energy() const override
    {
      return work;
    }

  private:
    Eigen::VectorXd reversed;        ///< R_{n_steps - 1} ... R_0 [m/N]
    Eigen::VectorXd forces;          ///< phi of the steps so far
    Eigen::Index    n_forces    = 0; ///< up to the last that is not zero
    Eigen::Index    step        = 0;
    double          known_force = 0., free = 0., work = 0.;
  };
} // namespace PlateImpact
