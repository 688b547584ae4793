#include "plate_impact/transient/full_system.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/large_deflection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace PlateImpact
{
  namespace
  {
    /// Of the energy, which all steps together may miss; of a change, in the
    /// energy norm, that is round-off if it does not get smaller.
    constexpr double tolerance = 1e-10, tolerance_of_round_off = 1e-21;

    /// Iterations of a step beyond which the next gets a tangent of its own,
    /// and beyond which this one does.
    constexpr unsigned int many_iterations = 6, too_many_iterations = 12;

    constexpr unsigned int most_iterations = 60;



    /// The motion of a plate with large deflections. With
    /// LargeDeflection::mean_forces() f beside K (z_0 + z_1) / 2 the midpoint
    /// rule conserves the energy of this plate as well. The increment d of a
    /// step solves
    ///   (c_0 M + K) d + 2 f(z, z + d) = c_1 M v - 2 K z + (phi_0 + phi_1) u
    /// by Newton's method, whose tangent is kept until it takes too many
    /// iterations.
    class LargeDeflectionStepper : public PlateMotion
    {
    public:
      /// @param scheme  conserves energy
      LargeDeflectionStepper(const NewmarkScheme &scheme, FullSystem &system)
        : scheme(scheme)
        , matrices(*system.matrices)
        , u(system.load)
        , plate(matrices.discretization)
        , damping(system.damping / scheme.dt)
        , tangent(make_linear_solver(matrices.solver_type, matrices.work))
        , linear(*matrices.sum(1. + 2. * damping, scheme.c0))
      {
        z = v = Kz = Mv = increment = Eigen::VectorXd::Zero(u.size());
        now = next = plate.stretched(z);
        renew_tangent();
      }

      double
      begin_step(const double begin_force) override
      {
        known_force  = scheme.c1 * Mv - 2. * Kz + begin_force * u;
        increment    = scheme.dt * v;
        n_iterations = n_with_tangent = 0;
        last_change                   = std::numeric_limits<double>::infinity();
        next                          = plate.stretched(z + increment);
        if (tangent_is_old)
          renew_tangent();
        return linearize();
      }

      std::optional<double>
      end_step(const double at_begin, const double at_end) override
      {
        const double force = at_begin + at_end;
        to_equilibrium += force * unit_response;
        increment += to_equilibrium;
        next = plate.stretched(z + increment);

        // what equilibrium lacked did no more work than this; how much of a
        // change is lacking still is known from the second on
        const double change = std::sqrt(
                       std::abs(to_equilibrium.dot(residual + force * u))),
                     work   = change * std::max(change, size_of_increment),
                     energy = std::max(largest_energy, next.energy) +
          std::abs(force * u.dot(increment)),
                     still = n_iterations == 0 ?
          1. :
          std::min(1., change / last_change);
        ++n_iterations;
        ++n_with_tangent;
        if (still * work <= tolerance / scheme.n_steps * energy ||
            (still > 0.3 && change * change <= tolerance_of_round_off * energy))
          {
            accept();
            return {};
          }
        if (n_iterations == most_iterations || !std::isfinite(change))
          throw ComputationError(
            "the equilibrium iterations of the plate did not converge; try a "
            "smaller Time/Time step");
        if (n_with_tangent == too_many_iterations ||
            (n_with_tangent > 1 && change > last_change))
          renew_tangent();
        last_change = change;
        return linearize();
      }

      double
      energy() const override
      {
        return PlateMotion::energy() + now.energy;
      }

    private:
      /// About the increment that the step has got to.
      /// @return displacement under the load without further force [m]
      double
      linearize()
      {
        residual.noalias() = as_eigen(linear) * increment;
        size_of_increment  = std::sqrt(increment.dot(residual));
        residual =
          known_force - residual - 2. * plate.mean_forces(now, next, damping);
        tangent->solve(residual, to_equilibrium);
        return w + u.dot(increment + to_equilibrium);
      }

      void
      renew_tangent()
      {
        const auto factorize = [this](const bool with_stresses) {
          auto matrix = std::make_unique<Epetra_CrsMatrix>(linear);
          plate.add_tangent(now, next, damping, with_stresses, *matrix);
          tangent->factorize(std::move(matrix));
        };
        try
          {
            factorize(true);
          }
        catch (const ComputationError &)
          {
            // compressed so much that it would buckle within the step
            factorize(false);
          }
        tangent->solve(u, unit_response);
        w_of_unit_response = u.dot(unit_response);
        n_with_tangent     = 0;
        tangent_is_old     = false;
      }

      void
      accept()
      {
        tangent_is_old = n_iterations > many_iterations;
        const Eigen::VectorXd K_increment =
          as_eigen(matrices.discretization.stiffness()) * increment;
        if (damping > 0.)
          dissipated += damping * increment.dot(K_increment) +
            plate.dissipated(now, next, damping);
        z += increment;
        Kz += K_increment;
        w            = u.dot(z);
        v            = 2. / scheme.dt * increment - v;
        Mv.noalias() = as_eigen(matrices.discretization.mass()) * v;
        std::swap(now, next);
        largest_energy = std::max(largest_energy, energy());
      }

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
  } // namespace



  std::unique_ptr<PlateMotion>
  FullSystem::motion(const NewmarkScheme &scheme)
  {
    if (is_linear)
      return SemidiscreteSystem::motion(scheme);
    return std::make_unique<LargeDeflectionStepper>(scheme, *this);
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
        (plate.is_nonlinear() && plate.section.is_unsymmetric()))
      return *compliance;
    Eigen::VectorXd x, residual;
    try
      {
        // a rigid motion in the plane, which the load does not excite, is kept
        // out by a little of M
        solve(plate.section.stretching != Stretching::none ?
                1e-6 * plate.square_of_bending() :
                0.,
              load,
              x);
      }
    catch (const ComputationError &)
      {
        // an element with spurious modes
        return *compliance;
      }
    multiply_stiffness(x, residual);
    residual -= load;
    const double error = residual.norm() / load.norm();
    // a bound, beyond round-off
    if (error < 1e-4)
      compliance = (1.001 + error) * load.dot(x);
    return *compliance;
  }
} // namespace PlateImpact
