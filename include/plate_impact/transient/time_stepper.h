#pragma once

#include "plate_impact/transient/impactor_stepper.h"
#include "plate_impact/transient/plate_motion.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <memory>

namespace PlateImpact
{
  /// Integrates plate and impactor in time: Newmark's method for both and one
  /// scalar contact equation per step (eqs. 19-31 of the paper), of plates with
  /// large deflections one per iteration of Newton's method.
  ///
  /// Without a force the average-acceleration scheme keeps the plate's energy
  /// E, and the displacement under the load never leaves +-sqrt(2 E c), c the
  /// static compliance. An impactor that is beyond and flies away has left for
  /// good.
  class TimeStepper
  {
  public:
    /// The plate must outlive the stepper.
    TimeStepper(const NewmarkScheme &scheme,
                SemidiscreteSystem  &plate,
                const Contact       &contact,
                const Impactor      &impactor)
      : scheme(scheme)
      , plate(plate)
      , plate_motion(plate.motion(scheme))
      , impactor_stepper(scheme, contact, impactor)
    {}

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
      return impactor_stepper.state();
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
      return impactor_stepper.impact();
    }

  private:
    /// As PlateMotion::end_step(); an error names the step.
    std::optional<double>
    end_plate_step(double at_begin, double at_end);
    /// Whether the plate can never reach the impactor again.
    bool
    is_out_of_reach();

    const NewmarkScheme          scheme;
    SemidiscreteSystem          &plate;
    std::unique_ptr<PlateMotion> plate_motion;
    ImpactorStepper              impactor_stepper;
  };
} // namespace PlateImpact
