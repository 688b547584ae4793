#include "plate_impact/estimator/recovered_resultants.h"

#include "plate_impact/plate/plate_mesh.h"


namespace PlateImpact
{
  using namespace dealii;

  std::vector<Point<2>>
  to_real(const Triangulation<2>::active_cell_iterator &cell,
          const std::vector<Point<2>>                  &unit_points)
  {
    std::vector<Point<2>> points;
    for (const Point<2> &unit_point : unit_points)
      points.push_back(
        mapping_of(cell).transform_unit_to_real_cell(cell, unit_point));
    return points;
  }



  Eigen::Map<const RowMajorMatrix>
  by_resultant(const RowMajorMatrix &values)
  {
    return {values.data(), 5 * values.rows(), values.cols() / 5};
  }



  RowMajorMatrix
  resultants_at(const PlateDiscretization               &discretization,
                const unsigned int                       cell,
                const Eigen::Matrix<double, 5, 5>       &factor,
                const CellOperator                      &strains,
                const Eigen::Ref<const Eigen::MatrixXd> &fields)
  {
    CellOperator values(strains.rows(), strains.cols());
    for (Eigen::Index row = 0; row < strains.rows(); row += 5)
      values.middleRows<5>(row).noalias() = factor * strains.middleRows<5>(row);
    Eigen::MatrixXd nodal_values;
    discretization.cell_values(cell, fields, nodal_values);
    RowMajorMatrix result(strains.rows() / 5, 5 * fields.cols());
    Eigen::Map<RowMajorMatrix>(result.data(), strains.rows(), fields.cols())
      .noalias() = values * nodal_values;
    return result;
  }



  RecoveredField
  recovered_field(const PlateDiscretization               &discretization,
                  const StressRecovery                    &recovery,
                  const Eigen::Matrix<double, 5, 5>       &factor,
                  const Eigen::Ref<const Eigen::MatrixXd> &fields)
  {
    return {recovery,
            [&discretization, factor, fields](const unsigned int cell) {
              return resultants_at(
                discretization,
                cell,
                factor,
                discretization.shape(cell).strains_at_samples,
                fields);
            }};
  }



  Eigen::MatrixXd
  recovered_resultants(const PlateDiscretization   &discretization,
                       const StressRecovery        &recovery,
                       const Eigen::VectorXd       &unknowns,
                       const std::vector<Point<2>> &unit_points)
  {
    RecoveredField  field = recovered_field(discretization,
                                           recovery,
                                           discretization.section().stiffness(),
                                           unknowns);
    Eigen::MatrixXd result(5 * unit_points.size(),
                           discretization.mesh().n_active_cells());
    RowMajorMatrix  values;
    for (const auto &cell : discretization.mesh().active_cell_iterators())
      {
        const unsigned int c = cell->active_cell_index();
        field.evaluate(c, unit_points, to_real(cell, unit_points), values);
        field.finish(c);
        result.col(c) = by_resultant(values);
      }
    return result;
  }
} // namespace PlateImpact
