#include "plate_impact/estimator/peak_force_error.h"

#include "plate_impact/estimator/error_estimator.h"
#include "plate_impact/estimator/recovered_field.h"

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



    /// Motions as combinations of few fields: fields, and the symmetric matrix
    /// of the products of their coordinates, summed over the times.
    struct Products
    {
      Eigen::MatrixXd fields, of_coordinates;
    };

    /// The error of a mesh, from the change of the force from the mesh before:
    /// no more than that, and a third where every cell is halved, since errors
    /// fall at least with the square of the size. Empty for about as many
    /// cells, which change little, whatever their error.
    std::optional<double>
    error_by_change(const double      change,
                    const std::size_t n_cells,
                    const std::size_t n_before)
    {
      if (n_cells < 1.5 * n_before)
        return {};
      return n_cells < 4 * n_before ? change : change / 3.;
    }



    Products
    products_of(const SemidiscreteSystem &system, const DualMotions &motions)
    {
      // of equal size, so that one tolerance serves both
      const Eigen::Index n            = motions.motion.cols();
      const double       motion_scale = motions.motion.norm(),
                   dual_scale         = motions.dual.norm();
      Eigen::MatrixXd states(motions.motion.rows(), 2 * n);
      states << motions.motion / motion_scale, motions.dual / dual_scale;
      const SemidiscreteSystem::Span span = system.span(states);

      const Eigen::MatrixXd combinations =
        leading_combinations(span.coordinates, tolerance_of_span);
      const Eigen::MatrixXd coordinates =
        combinations.transpose() * span.coordinates;
      const Eigen::MatrixXd product = motions.weight * motion_scale *
        dual_scale * coordinates.leftCols(n) *
        coordinates.rightCols(n).transpose();
      return {span.vectors * combinations,
              0.5 * (product + product.transpose())};
    }



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
    const Products products = products_of(system, motions);
    EnergyRoots    roots(discretization, recovery, products.fields);
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
          factor * (e * products.of_coordinates).cwiseProduct(e).sum();
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
        bar = estimate.bar_of_random_signs();
        if (change)
          bar = std::min(bar,
                         error_by_change(*change,
                                         estimate.cells.size(),
                                         before->n_cells)
                           .value_or(bar));
      }
    if (resolves_load)
      return bar;
    const double of_peak   = std::abs(peak - before->force) / peak;
    const bool   was_blind = !before->space || of_peak > *before->space;
    return std::max(bar, was_blind ? of_peak : 0.);
  }
} // namespace PlateImpact
