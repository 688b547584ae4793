#pragma once

#include "plate_impact/contact/contact.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/transient/newmark_scheme.h"

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

    /// Time since when no further contact is possible; empty as long as one is,
    /// for plates that are free to move and schemes that do not keep energy.
    /// [s]
    std::optional<double> separation_time;
  };


  /// The impactor's side of a transient: one scalar contact equation per step
  /// and the rigid mass under Newmark's method (eqs. 28-31 of the paper). Of
  /// the plate it needs two numbers a step, the displacement under the load
  /// without further force and that per unit of force.
  class ImpactorStepper
  {
  public:
    ImpactorStepper(const NewmarkScheme &scheme,
                    const Contact       &contact,
                    const Impactor      &impactor);

    /// Begins a step.
    /// @return force at its beginning that does not depend on its end [N]
    double
    begin_step();

    /// The unknown force phi of the step. [N]
    /// @param plate_free        displacement under the load at its end without
    ///                          phi [m]
    /// @param plate_compliance  that per unit of phi [m/N]
    /// @throws ComputationError naming the step
    double
    contact_force(double plate_free, double plate_compliance) const;

    /// Ends the step.
    /// @param phi                 the force of the step [N]
    /// @param plate_displacement  under the load at its end [m]
    /// @param plate_energy        at its end [J]
    /// @param plate_dissipated    by its damping, so far [J]
    /// @throws ComputationError naming step and quantity when a value is not
    ///         finite
    void
    end_step(double phi,
             double plate_displacement,
             double plate_energy,
             double plate_dissipated = 0.);

    /// From now on there is no contact force.
    void
    separate()
    {
      so_far.separation_time = current.time;
    }

    const ContactState &
    state() const
    {
      return current;
    }

    const Impact &
    impact() const
    {
      return so_far;
    }

  private:
    const NewmarkScheme scheme;
    Contact             contact;
    Impactor            impactor;
    ContactState        current;
    Impact              so_far;
    unsigned int        step        = 0;
    double              begin_force = 0.; ///< of the step [N]
  };
} // namespace PlateImpact
