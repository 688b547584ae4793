#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>

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
    using Cell = dealii::Triangulation<2>::active_cell_iterator;

    /// Resultants at the 2x2 Gauss points of a cell, by active index: 4 rows by
    /// m n columns, resultant n + field.
    using Sampler = std::function<RowMajorMatrix(unsigned int cell)>;

    /// @param recovery  must outlive this object
    RecoveredField(const StressRecovery &recovery,
                   unsigned int          n_resultants,
                   Sampler               sampler);

    /// A factor times the strains of fields, recovered. With large deflections
    /// each of them is a state, and not a combination of some.
    /// @param discretization, recovery, fields  must outlive this object
    RecoveredField(const PlateDiscretization               &discretization,
                   const StressRecovery                    &recovery,
                   const Eigen::MatrixXd                   &factor,
                   const Eigen::Ref<const Eigen::MatrixXd> &fields);

    /// Recovered resultants at points of the reference cell.
    /// @return a row per point by m n columns
    RowMajorMatrix
    evaluate(const Cell                          &cell,
             const std::vector<dealii::Point<2>> &unit_points);

    /// The cell will not be evaluated again.
    void
    finish(const Cell &cell)
    {
      for (const auto &corner : recovery.patches_at[cell->active_cell_index()])
        for (const unsigned int patch : corner)
          if (--n_cells_to_come[patch] == 0)
            coefficients[patch] = {};
    }

  private:
    void
    fit(const unsigned int patch)
    {
      const StressRecovery::Patch &it = recovery.patches[patch];
      for (const StressRecovery::Image &image : it.images)
        if (samples[image.cell].size() == 0)
          samples[image.cell] = sampler(image.cell);
      coefficients[patch] = it.coefficients(samples, n_resultants);
      for (const StressRecovery::Image &image : it.images)
        if (--n_patches_to_come[image.cell] == 0)
          samples[image.cell] = {};
    }

    const StressRecovery &recovery;
    const unsigned int    n_resultants;
    const Sampler         sampler;

    /// of cells and of patches; empty when not needed yet or no longer
    std::vector<RowMajorMatrix> samples, coefficients;

    /// patches that a cell, and cells that a patch is still needed for
    std::vector<unsigned int> n_patches_to_come, n_cells_to_come;
  };


  /// Resultants of n fields at the quadrature points of a cell, and what the
  /// recovery changes of them, as the roots of energies: the squares of a
  /// column, a row per point and resultant, sum up to the integral over the
  /// cell.
  struct EnergyRoots
  {
    /// All must outlive this object.
    /// @param fields  unknowns of the plate, a column per field
    EnergyRoots(const PlateDiscretization &discretization,
                const StressRecovery      &recovery,
                const Eigen::MatrixXd     &fields);

    /// Sets resultants and errors.
    void
    evaluate(const RecoveredField::Cell &cell);

    const PlateDiscretization &discretization;
    const Eigen::MatrixXd     &fields;
    const Eigen::MatrixXd      factor;    ///< of resultants, from strains
    RecoveredField             recovered; ///< with that factor
    RowMajorMatrix             resultants, errors;
  };


  /// A factor times the strains of n fields at points of a cell.
  /// @param strains  of the cell at the points
  /// @param fields   unknowns of the plate, a column per field
  /// @return a row per point by m n columns, resultant n + field, with m
  ///         resultants of the section
  RowMajorMatrix
  resultants_at(const PlateDiscretization               &discretization,
                unsigned int                             cell,
                const Eigen::MatrixXd                   &factor,
                const CellStrains                       &strains,
                const Eigen::Ref<const Eigen::MatrixXd> &fields);

  /// The same, a row per point and resultant by n columns.
  inline Eigen::Map<const RowMajorMatrix>
  by_resultant(const RowMajorMatrix &values, const unsigned int n_resultants)
  {
    return {values.data(),
            n_resultants * values.rows(),
            values.cols() / n_resultants};
  }

  /// Recovered resultants at points of all cells, for all states at once, since
  /// what a patch costs most is its place.
  /// @param states       unknowns of the plate, a column each
  /// @param unit_points  n of them on the reference cell
  /// @return a matrix per state: a row per resultant, column n cell + point
  std::vector<Eigen::MatrixXd>
  recovered_resultants(const PlateDiscretization               &discretization,
                       const StressRecovery                    &recovery,
                       const Eigen::Ref<const Eigen::MatrixXd> &states,
                       const std::vector<dealii::Point<2>>     &unit_points);
} // namespace PlateImpact
