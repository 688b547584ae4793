#ifndef plate_impact_estimator_recovered_field_h
#define plate_impact_estimator_recovered_field_h

#include <deal.II/base/point.h>

#include "plate_impact/estimator/stress_recovery.h"

#include <functional>
#include <vector>

namespace PlateImpact
{
  /// Resultants of n fields recovered by patches, cell after cell. Samples are
  /// taken and patches fitted when a cell first needs them, and forgotten with
  /// the last one that does: memory is for the cells at work, not for the mesh.
  class RecoveredField
  {
  public:
    /// Resultants at the 2x2 Gauss points of a cell, by active index: 4 rows by
    /// 5 n columns, resultant n + field.
    using Sampler = std::function<RowMajorMatrix(unsigned int cell)>;

    /// @param recovery  must outlive this object
    RecoveredField(const StressRecovery &recovery, Sampler sampler);

    /// Recovered resultants at points of a cell.
    /// @param unit_points  on the reference cell
    /// @param points       the same points on the plate [m]
    /// @param values       set to a row per point by 5 n columns
    void
    evaluate(unsigned int                         cell,
             const std::vector<dealii::Point<2>> &unit_points,
             const std::vector<dealii::Point<2>> &points,
             RowMajorMatrix                      &values);

    /// The cell will not be evaluated again.
    void
    finish(unsigned int cell);

  private:
    void
    fit(unsigned int patch);

    const StressRecovery &recovery;
    const Sampler         sampler;

    /// of cells and of patches; empty when not needed yet or no longer
    std::vector<RowMajorMatrix> samples, coefficients;

    /// patches that a cell, and cells that a patch is still needed for
    std::vector<unsigned int> n_patches_to_come, n_cells_to_come;
  };
} // namespace PlateImpact

#endif
