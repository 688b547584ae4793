#ifndef plate_impact_transient_time_stepper_h
#define plate_impact_transient_time_stepper_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/transient/impact.h"
#include "plate_impact/transient/impactor_stepper.h"
#include "plate_impact/transient/plate_stepper.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace PlateImpact
{
  /// Integrates plate and impactor in time: Newmark's method for both and one
  /// scalar contact equation per step (eqs. 19-31 of the paper).
  ///
  /// Without a force the average-acceleration scheme keeps the plate's energy
  /// E, and the displacement under the load never leaves +-sqrt(2 E c), c the
  /// static compliance. An impactor that is beyond and flies away has left for
  /// good.
  class TimeStepper
  {
  public:
    /// Factorizes the effective stiffness and computes the unit response.
    /// Plate, law and integration must outlive the stepper.
    TimeStepper(const TimeParameters     &time,
                SemidiscreteSystem       &plate,
                const Contact            &contact,
                const ContactIntegration &integration,
                const Impactor           &impactor);

    /// Steps that it takes to the end time.
    unsigned int
    n_steps() const;

    /// One step.
    /// @throws ComputationError naming step and quantity when a value is not
    ///         finite or the contact equation is not solved
    void
    advance();

    const ContactState &
    state() const;

    /// z, the unknowns of the plate.
    const Eigen::VectorXd &
    displacement() const;

    /// Change of the impactor's momentum so far. [N s]
    double
    impulse() const;

    /// Time since when no further contact is possible; empty as long as one is,
    /// for plates that are free to move and schemes that do not keep energy.
    /// [s]
    std::optional<double>
    separation_time() const;

    /// Steps in which the contact equation had a solution other than no force.
    unsigned int
    n_contact_steps() const;

  private:
    /// Whether the plate can never reach the impactor again.
    bool
    is_out_of_reach();

    const NewmarkScheme       scheme;
    SemidiscreteSystem       &plate;
    const ContactIntegration &integration;
    PlateStepper              plate_stepper;
    ImpactorStepper           impactor_stepper;
    std::optional<double>     separated_at;
  };


  /// Steps to the end time.
  /// @param listener  told after every step, from 1
  /// @return the impact from the present state on
  /// @throws ComputationError as TimeStepper::advance()
  Impact
  step_to_end(TimeStepper                             &stepper,
              const std::function<void(unsigned int)> &listener = {});
} // namespace PlateImpact

#endif
