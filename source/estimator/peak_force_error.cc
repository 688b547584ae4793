#include "plate_impact/estimator/peak_force_error.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/estimator/energy_norm_estimator.h"

namespace PlateImpact
{
  namespace
  {
    /// How the force changes on a plate that is softer by what recovery finds
    /// missing, and lighter by what the mass has for waves: the peak, which may
    /// agree by accident, and all around it.
    PeakForceError::Change
    change_on_softer_plate(const LoadedPlate        &loaded,
                           const PeakForceProblem   &problem,
                           const DualWeightedErrors &errors,
                           const ContactHistory     &history)
    {
      SemidiscreteSystem  &system = *problem.system;
      SoftenedSystem       softer(system, errors.missed);
      const ContactHistory of_softer = loaded.on_other_plate(softer, history);
      // in the same steps and vectors, which have errors of their own
      const ContactHistory here = loaded.on_other_plate(system, history);
      const ContactState  &peak = here.peak();
      return {of_softer.peak().force / peak.force - 1.,
              of_softer.difference_around(peak.time, here) / peak.force,
              problem.crossings_of_waves};
    }



    /// Whether recovery finds energy at soft edges that the stiffness does not
    /// miss; on strips and meshes of few rows, where such cells make up most of
    /// the plate, they count all the same.
    bool
    leaves_soft_edges_out(const PlateDiscretization &discretization)
    {
      double area = 0., at_edges = 0.;
      for (const auto &cell : discretization.mesh().active_cell_iterators())
        {
          area += cell->measure();
          if (discretization.is_at_soft_edge(cell))
            at_edges += cell->measure();
        }
      return discretization.element.has_reduced_shear() &&
        at_edges < 0.6 * area;
    }
  } // namespace



  DualWeightedErrors
  dual_weighted_errors(const PlateDiscretization &discretization,
                       const StressRecovery      &recovery,
                       const SemidiscreteSystem  &system,
                       const DualMotions         &motions)
  {
    // motions as combinations of few fields, which leave out 1e-4 of the
    // largest; of equal size, so that one tolerance serves both
    const Eigen::Index n            = motions.motion.cols();
    const double       motion_scale = motions.motion.norm(),
                 dual_scale         = motions.dual.norm();
    Eigen::MatrixXd states(motions.motion.rows(), 2 * n);
    states << motions.motion / motion_scale, motions.dual / dual_scale;
    const SemidiscreteSystem::Span span = system.span(states);
    const Eigen::MatrixXd          combinations =
      leading_combinations(span.coordinates, 1e-4);
    const Eigen::MatrixXd coordinates =
      combinations.transpose() * span.coordinates;
    // of the coordinates, summed over the times
    const Eigen::MatrixXd product = motions.weight * motion_scale * dual_scale *
      coordinates.leftCols(n) * coordinates.rightCols(n).transpose();
    const Eigen::MatrixXd products = 0.5 * (product + product.transpose());
    DualWeightedErrors    result;
    result.cells.resize(discretization.mesh().n_active_cells());
    MissedByMesh &missed = result.missed;
    missed.motions       = system.states(span, combinations);
    missed.energies.setZero(combinations.cols(), combinations.cols());
    missed.masses                    = missed.energies;
    const Eigen::MatrixXd fields     = span.vectors * combinations;
    const PlateElement   &element    = discretization.element;
    const bool            leaves_out = leaves_soft_edges_out(discretization);
    // integrals are over one of the parts of the plate
    const double n_parts = discretization.n_parts;
    visit_energies(
      discretization,
      recovery,
      fields,
      [&](const auto &cell, const auto &, const auto &e, auto &) {
        const unsigned int i = cell->active_cell_index();
        result.cells[i]      = n_parts * (e * products).cwiseProduct(e).sum();
        if (!leaves_out || !discretization.is_at_soft_edge(cell))
          missed.energies.selfadjointView<Eigen::Lower>()
            .rankUpdate(e.transpose(), n_parts);
        if (element.mass_of_deflection == PlateMass::consistent)
          return;
        const Eigen::MatrixXd w =
          discretization.cell_values(i, fields)(element.dofs_of(deflection),
                                                Eigen::all);
        missed.masses += n_parts * w.transpose() *
          element.wave_mass(discretization.shape(i), discretization.section) *
          w;
      });
    return result;
  }



  std::optional<PeakForceError>
  estimated_peak_force_error(const PlateDiscretization &discretization,
                             const StressRecovery      &recovery,
                             const LoadedPlate         &loaded,
                             const ContactHistory      &history)
  {
    const auto problem = loaded.peak_force_problem(history);
    if (!problem)
      return {};
    const DualWeightedErrors errors = dual_weighted_errors(discretization,
                                                           recovery,
                                                           *problem->system,
                                                           problem->motions);
    PeakForceError           result{errors.cells / history.peak().force,
                          {},
                          safety_of_bar *
                            discretization.element.error_over_recovered()};
    // the sum of absolute values, which is larger, stays where that fails
    try
      {
        if (problem->returns_of_waves > 1.)
          result.on_softer_plate =
            change_on_softer_plate(loaded, *problem, errors, history);
      }
    catch (const ComputationError &)
      {}
    return result;
  }



  std::optional<double>
  peak_force_error_by_mesh(const PeakForceError            &estimate,
                           const double                     peak,
                           const std::optional<PeakOnMesh> &before,
                           const bool                       resolves_load)
  {
    const double bar = estimate.bar();
    // much on a first mesh says nothing
    if (!before && (!resolves_load || bar > estimate.safety * 0.05))
      return {};
    if (!before || (resolves_load && !estimate.on_softer_plate))
      return bar;
    const double of_peak = std::abs(peak - before->force) / peak;
    const bool   was_blind =
      before->space ? of_peak > *before->space : !resolves_load;
    return was_blind ? std::max(bar, of_peak) : bar;
  }
} // namespace PlateImpact
