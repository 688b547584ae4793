#include "plate_impact/estimator/peak_force_error.h"

#include "plate_impact/estimator/recovered_resultants.h"

#include <Eigen/QR>

#include <cmath>
#include <numeric>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// What combinations of the motions leave out, relative to the largest.
    constexpr double tolerance_of_span = 1e-4;



    /// Motions as combinations of few fields: fields, and the symmetric matrix
    /// of the products of their coordinates, summed over the times.
    struct Products
    {
      Eigen::MatrixXd fields, of_coordinates;
    };

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

      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
      qr.setThreshold(tolerance_of_span);
      qr.compute(span.coordinates);
      const Eigen::MatrixXd combinations = qr.householderQ() *
        Eigen::MatrixXd::Identity(span.coordinates.rows(), qr.rank());
      const Eigen::MatrixXd coordinates =
        combinations.transpose() * span.coordinates;
      const Eigen::MatrixXd product = motions.weight * motion_scale *
        dual_scale * coordinates.leftCols(n) *
        coordinates.rightCols(n).transpose();
      return {span.vectors * combinations,
              0.5 * (product + product.transpose())};
    }
  } // namespace



  double
  PeakForceError::sum() const
  {
    return std::accumulate(cells.begin(), cells.end(), 0.);
  }



  double
  PeakForceError::sum_of_absolutes() const
  {
    return std::accumulate(cells.begin(),
                           cells.end(),
                           0.,
                           [](const double so_far, const double cell) {
                             return so_far + std::abs(cell);
                           });
  }



  PeakForceError
  estimated_peak_force_error(const PlateDiscretization &discretization,
                             const StressRecovery      &recovery,
                             const SemidiscreteSystem  &system,
                             const DualMotions         &motions,
                             const double               peak)
  {
    const Products                    products = products_of(system, motions);
    const Eigen::Matrix<double, 5, 5> factor =
      discretization.section().root_of_compliance() *
      discretization.section().stiffness();
    RecoveredField field =
      recovered_field(discretization, recovery, factor, products.fields);
    const std::vector<Point<2>> &unit_points =
      discretization.element().quadrature().get_points();
    // integrals are over one of the parts of the plate
    const double   factor_of_cells = discretization.n_parts() / peak;
    PeakForceError result;
    result.cells.resize(discretization.mesh().n_active_cells());
    RowMajorMatrix error;
    for (const auto &cell : discretization.mesh().active_cell_iterators())
      {
        const unsigned int c     = cell->active_cell_index();
        const CellShape   &shape = discretization.shape(c);
        field.evaluate(c, unit_points, to_real(cell, unit_points), error);
        error -= resultants_at(discretization,
                               c,
                               factor,
                               shape.strains_at_quadrature,
                               products.fields);
        for (unsigned int q = 0; q < shape.weights.size(); ++q)
          error.row(q) *= std::sqrt(shape.weights[q]);
        const auto e = by_resultant(error);
        result.cells[c] =
          factor_of_cells * (e * products.of_coordinates).cwiseProduct(e).sum();
        field.finish(c);
      }
    return result;
  }
} // namespace PlateImpact
