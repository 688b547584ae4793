#pragma once

#include "plate_impact/plate/large_deflection.h"
#include "plate_impact/transient/linear_solver.h"
#include "plate_impact/transient/newmark_scheme.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

namespace PlateImpact
{
  /// The motion of a plate with large deflections. With
  /// LargeDeflection::mean_forces() f beside K (z_0 + z_1) / 2 the midpoint
  /// rule conserves the energy of this plate as well. The increment d of a step
  /// solves
  ///   (c_0 M + K) d + 2 f(z, z + d) = c_1 M v - 2 K z + (phi_0 + phi_1) u
  /// by Newton's method, whose tangent is kept until it takes too many
  /// iterations.
  class LargeDeflectionStepper : public PlateMotion
  {
  public:
    /// @param scheme    conserves energy
    /// @param matrices  of the plate; must outlive the stepper
    /// @param load      as SemidiscreteSystem::load(); must outlive the stepper
    LargeDeflectionStepper(const NewmarkScheme   &scheme,
                           EffectiveStiffness    &matrices,
                           const Eigen::VectorXd &load);

    double
    begin_step(double begin_force) override;

    std::optional<double>
    end_step(double at_begin, double at_end) override;

    double
    energy() const override
    {
      return PlateMotion::energy() + now.energy;
    }

  private:
    /// About the increment that the step has got to.
    /// @return displacement under the load without further force [m]
    double
    linearize();
    void
    renew_tangent();
    void
    accept();

    const NewmarkScheme                 scheme;
    EffectiveStiffness                 &matrices;
    const Eigen::VectorXd              &u;
    const LargeDeflection               plate;
    const double                        damping; ///< b over the step [-]
    const std::unique_ptr<LinearSolver> tangent;

    Epetra_CrsMatrix linear;    ///< c_0 M + (1 + 2 damping) K
    StretchedPlate   now, next; ///< at the beginning and the end of the step
    Eigen::VectorXd  to_equilibrium, residual; ///< without further force
    Eigen::VectorXd  known_force;              ///< what does not depend on d
    double           largest_energy = 0.;

    unsigned int n_iterations = 0, n_with_tangent = 0; ///< of the step
    double last_change = 0., size_of_increment = 0.;   ///< in the energy norm
    bool   tangent_is_old = false;
  };
} // namespace PlateImpact
