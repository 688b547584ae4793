#include "plate_impact/estimator/peak_force_error.h"

#include "plate_impact/estimator/energy_norm_estimator.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// What combinations of the motions leave out, relative to the largest.
    constexpr double tolerance_of_span = 1e-4;

    /// Of the force: beyond, a first order estimate on a first mesh says
    /// nothing.
    constexpr double largest_on_first_mesh = 0.05;

    /// Of waves, from which on what cells contribute has random signs: chosen
    /// on random heavy impactors (doc/theory.md).
    constexpr double many_returns = 3.;



    /// Of values of cells by active index, over rings as wide as the cell that
    /// each begins with.
    std::vector<double>
    sums_over_rings(const Triangulation<2>    &mesh,
                    const std::vector<double> &values)
    {
      std::vector<Triangulation<2>::active_cell_iterator> cells;
      for (const auto &cell : mesh.active_cell_iterators())
        cells.push_back(cell);
      const auto distance = [](const auto &cell) {
        return cell->center().norm();
      };
      std::sort(cells.begin(), cells.end(), [&](const auto &a, const auto &b) {
        return distance(a) < distance(b);
      });
      std::vector<double> sums;
      double              end = 0.;
      for (const auto &cell : cells)
        {
          if (sums.empty() || distance(cell) > end)
            {
              sums.push_back(0.);
              end = distance(cell) + std::sqrt(cell->measure());
            }
          sums.back() += values[cell->active_cell_index()];
        }
      return sums;
    }
  } // namespace



  PeakForceError
  estimated_peak_force_error(const PlateDiscretization &discretization,
                             const StressRecovery      &recovery,
                             const SemidiscreteSystem  &system,
                             const DualMotions         &motions,
                             const double               peak)
  {
    // motions as combinations of few fields; of equal size, so that one
    // tolerance serves both
    const Eigen::Index n            = motions.motion.cols();
    const double       motion_scale = motions.motion.norm(),
                 dual_scale         = motions.dual.norm();
    Eigen::MatrixXd states(motions.motion.rows(), 2 * n);
    states << motions.motion / motion_scale, motions.dual / dual_scale;
    const SemidiscreteSystem::Span span = system.span(states);
    const Eigen::MatrixXd          combinations =
      leading_combinations(span.coordinates, tolerance_of_span);
    const Eigen::MatrixXd coordinates =
      combinations.transpose() * span.coordinates;
    // of the coordinates, summed over the times
    const Eigen::MatrixXd product = motions.weight * motion_scale * dual_scale *
      coordinates.leftCols(n) * coordinates.rightCols(n).transpose();
    const Eigen::MatrixXd products = 0.5 * (product + product.transpose());
    const Eigen::MatrixXd fields   = span.vectors * combinations;
    EnergyRoots           roots(discretization, recovery, fields);
    // integrals are over one of the parts of the plate
    const double   factor = discretization.n_parts / peak;
    PeakForceError result;
    result.cells.resize(discretization.mesh().n_active_cells());
    for (const auto &cell : discretization.mesh().active_cell_iterators())
      {
        roots.evaluate(cell);
        const auto e =
          by_resultant(roots.errors, discretization.section().n_resultants());
        result.cells[cell->active_cell_index()] =
          factor * (e * products).cwiseProduct(e).sum();
        roots.recovered.finish(cell);
      }
    result.rings = sums_over_rings(discretization.mesh(), result.cells);
    return result;
  }



  std::optional<double>
  peak_force_error_by_mesh(const PeakForceError            &estimate,
                           const double                     peak,
                           const std::optional<PeakOnMesh> &before,
                           const bool                       resolves_load,
                           const double                     returns,
                           const std::optional<double>     &change)
  {
    if (!before &&
        (!resolves_load ||
         estimate.bar() > safety_of_bar * largest_on_first_mesh))
      return {};
    double bar = estimate.bar();
    if (returns > many_returns)
      {
        // A third of the change where every cell is halved: errors fall at
        // least with the square of the size. About as many cells change little,
        // whatever their error.
        const std::size_t n_cells = estimate.cells.size();
        bar                       = estimate.bar_of_random_signs();
        if (change && n_cells >= 1.5 * before->n_cells)
          bar =
            std::min(bar,
                     n_cells < 4 * before->n_cells ? *change : *change / 3.);
      }
    if (resolves_load)
      return bar;
    const double of_peak   = std::abs(peak - before->force) / peak;
    const bool   was_blind = !before->space || of_peak > *before->space;
    return std::max(bar, was_blind ? of_peak : 0.);
  }
} // namespace PlateImpact
