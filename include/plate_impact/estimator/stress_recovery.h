#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace PlateImpact
{
  /// Stores the rows of a point, or the terms of a polynomial, side by side.
  using RowMajorMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;


  /// Superconvergent patch recovery (Zienkiewicz & Zhu 1992,
  /// doi:10.1002/nme.1620330702; eqs. 9-15 of the paper) of the stress
  /// resultants from samples at the 2x2 Gauss points of every cell.
  ///
  /// Around each vertex a polynomial P a, P = [1, x, y, x^2, xy, y^2, x^2 y,
  /// xy^2], is fitted to the samples of the cells that touch it, by least
  /// squares. In a cell the four polynomials of its corners are blended with
  /// the bilinear shape functions; at the nodes of the element this is the
  /// average over patches that the paper takes. Since everything is linear in
  /// the samples, a patch is one small matrix, built once per mesh.
  ///
  /// Samples are mirrored across the planes of symmetry. Vertices on an edge of
  /// the plate use the patches of their neighbours in the interior, averaged.
  /// So do hanging vertices: the twelve samples of their three cells do
  /// determine eight terms, but such a fit follows the error that it should
  /// expose (measured on a simply supported plate: cells along a change of
  /// level then have half of their error in the estimate). A patch whose
  /// samples do not determine the polynomial grows by the cells around it.
  ///
  /// This is the part that depends on the mesh alone; RecoveredField applies
  /// it.
  struct StressRecovery
  {
    static constexpr unsigned int n_terms = 8, samples_per_cell = 4;

    using Terms = Eigen::Matrix<double, 1, n_terms>;

    /// An image of a cell in the plate unfolded across its planes of symmetry.
    struct Image
    {
      unsigned int cell; ///< active index
      bool         mirrored_x, mirrored_y;

      bool
      operator<(const Image &other) const
      {
        return std::tie(cell, mirrored_x, mirrored_y) <
          std::tie(other.cell, other.mirrored_x, other.mirrored_y);
      }
    };

    /// A polynomial around a vertex.
    struct Patch
    {
      dealii::Point<2>   centre;
      double             size;
      std::vector<Image> images; ///< cells whose samples it is fitted to

      /// n_terms x number of samples; congruent patches share theirs
      std::shared_ptr<const Eigen::MatrixXd> fit;

      /// P of eq. 10 in the coordinates of the patch, centred and scaled: in
      /// metres the normal matrix of eq. 15 has a condition number of 4e13 for
      /// cells of 1 cm.
      Terms
      polynomial(const dealii::Point<2> &point) const
      {
        const auto   position = (point - centre) / size;
        const double x = position[0], y = position[1];
        Terms        P;
        P << 1., x, y, x * x, x * y, y * y, x * x * y, x * y * y;
        return P;
      }

      /// Coefficients a from samples of n fields with m resultants at once: a
      /// row per term by m n columns.
      /// @param samples  of each cell: a row per Gauss point by m n columns,
      ///                 resultant n + field
      RowMajorMatrix
      coefficients(const std::vector<RowMajorMatrix> &samples,
                   unsigned int                       n_resultants) const;
    };

    using IsRough = std::function<bool(const dealii::Point<2> &)>;

    /// @param mesh      of the plate with the ids of PlateBoundary
    /// @param is_rough  tells points across which no polynomial fits, as where
    ///                  the shear force jumps under a line load, or at which no
    ///                  patch is wanted: vertices there use their neighbours as
    ///                  on an edge
    explicit StressRecovery(
      const dealii::Triangulation<2> &mesh,
      const IsRough &is_rough = [](const auto &) { return false; });

    std::vector<Patch> patches;

    /// By cell and corner, the patches whose polynomials are averaged there.
    std::vector<std::array<std::vector<unsigned int>, 4>> patches_at;

  private:
    struct PatchMaker;
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

    /// A factor times the strains of fields, recovered. With large deflections
    /// each of them is a state, and not a combination of some.
    /// @param discretization, recovery, fields  must outlive this object
    RecoveredField(const PlateDiscretization               &discretization,
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
