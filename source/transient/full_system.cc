#include "plate_impact/transient/full_system.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/transient/large_deflection_stepper.h"

#include <limits>

namespace PlateImpact
{
  std::unique_ptr<PlateMotion>
  FullSystem::motion(const NewmarkScheme &scheme)
  {
    if (is_linear())
      return SemidiscreteSystem::motion(scheme);
    return std::make_unique<LargeDeflectionStepper>(scheme, *matrices, load());
  }



  double
  FullSystem::static_compliance()
  {
    if (compliance)
      return *compliance;
    compliance = std::numeric_limits<double>::infinity(); // if not found below
    const PlateDiscretization &plate = matrices->discretization;
    // strains of the middle surface that fit no displacements may take less
    // energy than those of a linear plate where bending causes them
    if (plate.is_free() ||
        (plate.is_nonlinear() && plate.section().is_unsymmetric()))
      return *compliance;
    const Eigen::VectorXd &u = load();
    Eigen::VectorXd        x, residual;
    try
      {
        // a rigid motion in the plane, which the load does not excite, is kept
        // out by a little of M
        solve(plate.section().stretching != Stretching::none ?
                1e-6 * plate.square_of_bending() :
                0.,
              u,
              x);
      }
    catch (const ComputationError &)
      {
        // an element with spurious modes
        return *compliance;
      }
    multiply_stiffness(x, residual);
    residual -= u;
    const double error = residual.norm() / u.norm();
    // a bound, beyond round-off
    if (error < 1e-4)
      compliance = (1.001 + error) * u.dot(x);
    return *compliance;
  }
} // namespace PlateImpact
