#ifndef plate_impact_estimator_recovered_resultants_h
#define plate_impact_estimator_recovered_resultants_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include "plate_impact/estimator/recovered_field.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>

#include <vector>

namespace PlateImpact
{
  /// A factor times the strains of n fields at points of a cell.
  /// @param strains  of the cell at the points, five rows each
  /// @param fields   unknowns of the plate, a column per field
  /// @return a row per point by 5 n columns, resultant n + field
  RowMajorMatrix
  resultants_at(const PlateDiscretization               &discretization,
                unsigned int                             cell,
                const Eigen::Matrix<double, 5, 5>       &factor,
                const CellOperator                      &strains,
                const Eigen::Ref<const Eigen::MatrixXd> &fields);

  /// The same, five rows per point by n columns.
  Eigen::Map<const RowMajorMatrix>
  by_resultant(const RowMajorMatrix &values);

  /// A factor times the strains of n fields, recovered.
  /// @param discretization, recovery, fields  must outlive the result
  RecoveredField
  recovered_field(const PlateDiscretization               &discretization,
                  const StressRecovery                    &recovery,
                  const Eigen::Matrix<double, 5, 5>       &factor,
                  const Eigen::Ref<const Eigen::MatrixXd> &fields);

  /// Recovered resultants of one state: 5 point + resultant for points of a
  /// cell, a column each.
  /// @param unit_points  on the reference cell
  Eigen::MatrixXd
  recovered_resultants(const PlateDiscretization           &discretization,
                       const StressRecovery                &recovery,
                       const Eigen::VectorXd               &unknowns,
                       const std::vector<dealii::Point<2>> &unit_points);

  /// Points of the reference cell on the plate.
  std::vector<dealii::Point<2>>
  to_real(const dealii::Triangulation<2>::active_cell_iterator &cell,
          const std::vector<dealii::Point<2>>                  &unit_points);
} // namespace PlateImpact

#endif
