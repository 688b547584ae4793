#include "plate_impact/estimator/recovered_field.h"

#include <deal.II/base/geometry_info.h>

#include "plate_impact/plate/plate_mesh.h"

#include <cmath>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  RecoveredField::RecoveredField(const StressRecovery &recovery,
                                 const unsigned int    n_resultants,
                                 Sampler               sampler)
    : recovery(recovery)
    , n_resultants(n_resultants)
    , sampler(std::move(sampler))
    , samples(recovery.patches_at.size())
    , coefficients(recovery.patches.size())
    , n_patches_to_come(samples.size())
    , n_cells_to_come(coefficients.size())
  {
    for (const StressRecovery::Patch &patch : recovery.patches)
      for (const StressRecovery::Image &image : patch.images)
        ++n_patches_to_come[image.cell];
    for (const auto &corners : recovery.patches_at)
      for (const auto &corner : corners)
        for (const unsigned int patch : corner)
          ++n_cells_to_come[patch];
  }



  RecoveredField::RecoveredField(
    const PlateDiscretization               &discretization,
    const StressRecovery                    &recovery,
    const Eigen::MatrixXd                   &factor,
    const Eigen::Ref<const Eigen::MatrixXd> &fields)
    : RecoveredField(
        recovery,
        factor.rows(),
        [&discretization, factor, fields](const unsigned int cell) {
          return resultants_at(discretization,
                               cell,
                               factor,
                               discretization.shape(cell).at_samples,
                               fields);
        })
  {}



  RowMajorMatrix
  RecoveredField::evaluate(const Cell                  &cell,
                           const std::vector<Point<2>> &unit_points)
  {
    const unsigned int    n_points = unit_points.size();
    std::vector<Point<2>> points;
    for (const Point<2> &unit_point : unit_points)
      points.push_back(
        mapping_of(cell).transform_unit_to_real_cell(cell, unit_point));
    RowMajorMatrix  values(n_points, 0);
    Eigen::VectorXd blend(n_points);
    Eigen::MatrixXd weights(n_points, StressRecovery::n_terms);
    for (unsigned int v = 0; v < 4; ++v)
      {
        for (unsigned int q = 0; q < n_points; ++q)
          blend[q] =
            GeometryInfo<2>::d_linear_shape_function(unit_points[q], v);
        if (blend.isZero(0.))
          continue;
        const auto &patches = recovery.patches_at[cell->active_cell_index()][v];
        for (const unsigned int patch : patches)
          {
            if (coefficients[patch].size() == 0)
              fit(patch);
            for (unsigned int q = 0; q < n_points; ++q)
              weights.row(q) = blend[q] / patches.size() *
                recovery.patches[patch].polynomial(points[q]);
            if (values.cols() == 0)
              values.setZero(n_points, coefficients[patch].cols());
            values.noalias() += weights * coefficients[patch];
          }
      }
    return values;
  }



  EnergyRoots::EnergyRoots(const PlateDiscretization &discretization,
                           const StressRecovery      &recovery,
                           const Eigen::MatrixXd     &fields)
    : discretization(discretization)
    , fields(fields)
    // Resultants s are scaled to R s, whose square is their energy: recovery is
    // linear, and R mixes moments of the same parity only.
    , factor(discretization.section().root_of_compliance() *
             discretization.section().stiffness())
    , recovered(discretization, recovery, factor, fields)
  {}



  void
  EnergyRoots::evaluate(const RecoveredField::Cell &cell)
  {
    const CellShape &shape = discretization.shape(cell->active_cell_index());
    resultants             = resultants_at(discretization,
                               cell->active_cell_index(),
                               factor,
                               shape.at_quadrature,
                               fields);
    errors =
      recovered.evaluate(cell, discretization.element.quadrature.get_points()) -
      resultants;
    for (unsigned int q = 0; q < shape.weights.size(); ++q)
      {
        resultants.row(q) *= std::sqrt(shape.weights[q]);
        errors.row(q) *= std::sqrt(shape.weights[q]);
      }
  }



  RowMajorMatrix
  resultants_at(const PlateDiscretization               &discretization,
                const unsigned int                       cell,
                const Eigen::MatrixXd                   &factor,
                const CellStrains                       &strains,
                const Eigen::Ref<const Eigen::MatrixXd> &fields)
  {
    const CellOperator   &linear = strains.linear;
    const Eigen::Index    m = factor.rows(), n = fields.cols();
    const Eigen::MatrixXd nodal_values =
      discretization.cell_values(cell, fields);
    RowMajorMatrix             result(linear.rows() / m, m * n);
    Eigen::Map<RowMajorMatrix> by_row(result.data(), linear.rows(), n);
    if (!discretization.is_nonlinear())
      {
        CellOperator values(linear.rows(), linear.cols());
        for (Eigen::Index row = 0; row < linear.rows(); row += m)
          values.middleRows(row, m).noalias() =
            factor * linear.middleRows(row, m);
        by_row.noalias() = values * nodal_values;
        return result;
      }
    const Eigen::MatrixXd all =
      discretization.element.evaluate(strains, nodal_values);
    for (Eigen::Index row = 0; row < linear.rows(); row += m)
      by_row.middleRows(row, m).noalias() = factor * all.middleRows(row, m);
    return result;
  }



  std::vector<Eigen::MatrixXd>
  recovered_resultants(const PlateDiscretization               &discretization,
                       const StressRecovery                    &recovery,
                       const Eigen::Ref<const Eigen::MatrixXd> &states,
                       const std::vector<Point<2>>             &unit_points)
  {
    RecoveredField               field(discretization,
                         recovery,
                         discretization.section().stiffness(),
                         states);
    const unsigned int           m = discretization.section().n_resultants();
    const std::size_t            n_states = states.cols();
    const std::size_t            n_points = unit_points.size();
    std::vector<Eigen::MatrixXd> result(n_states);
    for (Eigen::MatrixXd &resultants : result)
      resultants.resize(m, n_points * discretization.mesh().n_active_cells());
    for (const auto &cell : discretization.mesh().active_cell_iterators())
      {
        const RowMajorMatrix values = field.evaluate(cell, unit_points);
        field.finish(cell);
        const auto first = n_points * cell->active_cell_index();
        for (std::size_t state = 0; state < n_states; ++state)
          for (unsigned int i = 0; i < m; ++i)
            result[state].row(i).segment(first, n_points) =
              values.col(n_states * i + state).transpose();
      }
    return result;
  }
} // namespace PlateImpact
