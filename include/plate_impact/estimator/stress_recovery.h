#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <Eigen/Core>

#include <array>
#include <functional>
#include <memory>
#include <tuple>
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

    /// Tells points across which no polynomial fits, as under a line load,
    /// where the shear force jumps, or at which no patch is wanted: vertices
    /// there use their neighbours as on an edge.
    using IsRough = std::function<bool(const dealii::Point<2> &)>;

    /// @param mesh  of the plate with the ids of PlateBoundary
    explicit StressRecovery(const dealii::Triangulation<2> &mesh,
                            const IsRough                  &is_rough = {});

    std::vector<Patch> patches;

    /// By cell and corner, the patches whose polynomials are averaged there.
    std::vector<std::array<std::vector<unsigned int>, 4>> patches_at;

  private:
    class PatchFinder;
  };
} // namespace PlateImpact
