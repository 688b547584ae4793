#include "plate_impact/transient/large_deflection_stepper.h"

#include "plate_impact/base/exceptions.h"

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
  } // namespace



  LargeDeflectionStepper::LargeDeflectionStepper(const NewmarkScheme &scheme,
                                                 EffectiveStiffness  &matrices,
                                                 const Eigen::VectorXd &load)
    : scheme(scheme)
    , matrices(matrices)
    , u(load)
    , plate(matrices.discretization)
    , damping(matrices.damping / scheme.dt)
    , tangent(make_linear_solver(matrices.solver_type, matrices.work))
    , linear(matrices.discretization.stiffness())
  {
    z = v = Kz = Mv = increment = Eigen::VectorXd::Zero(u.size());
    now = next = plate.stretched(z);
    linear.Scale(1. + 2. * damping);
    matrices.add_mass(scheme.c0, linear);
    renew_tangent();
  }



  void
  LargeDeflectionStepper::renew_tangent()
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



  double
  LargeDeflectionStepper::begin_step(const double begin_force)
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



  double
  LargeDeflectionStepper::linearize()
  {
    residual.noalias() = as_eigen(linear) * increment;
    size_of_increment  = std::sqrt(increment.dot(residual));
    residual =
      known_force - residual - 2. * plate.mean_forces(now, next, damping);
    tangent->solve(residual, to_equilibrium);
    return w + u.dot(increment + to_equilibrium);
  }



  std::optional<double>
  LargeDeflectionStepper::end_step(const double at_begin, const double at_end)
  {
    const double force = at_begin + at_end;
    to_equilibrium += force * unit_response;
    increment += to_equilibrium;
    next = plate.stretched(z + increment);

    // what equilibrium lacked did no more work than this; how much of a change
    // is lacking still is known from the second on
    const double change = std::sqrt(
                   std::abs(to_equilibrium.dot(residual + force * u))),
                 work   = change * std::max(change, size_of_increment),
                 energy = std::max(largest_energy, next.energy) +
      std::abs(force * u.dot(increment)),
                 still =
                   n_iterations == 0 ? 1. : std::min(1., change / last_change);
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



  void
  LargeDeflectionStepper::accept()
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
} // namespace PlateImpact
