#ifndef plate_impact_stress_recovery_h
#define plate_impact_stress_recovery_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <Eigen/Core>

#include <array>
#include <functional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace PlateImpact
{
  /// Stores the rows of a point, or the terms of a polynomial, side by side.
  using RowMajorMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;


  /// Superconvergent patch recovery (Zienkiewicz & Zhu 1992,
  /// doi:10.1002/nme.1620330702; eqs. 9-15 of the paper) of the five stress
  /// resultants from samples at the 2x2 Gauss points of every cell.
  ///
  /// Around each vertex a polynomial P a, P = [1, x, y, x^2, xy, y^2, x^2 y,
  /// xy^2], is fitted to the samples of the cells that touch it, by least
  /// squares. In a cell the four polynomials of its corners are blended with
  /// the bilinear shape functions; at the nodes of the element this is the
  /// average over patches that the paper takes. Since everything is linear in
  /// the samples, a patch is one small matrix, built once per mesh.
  ///
  /// What makes it work on every patch:
  ///  - coordinates are centred at the vertex and scaled by the patch (in
  ///  metres the
  ///    normal matrix of eq. 15 has a condition number of 4e13 for 1 cm), and
  ///    the fit uses a rank-revealing orthogonal decomposition, not eq. 14;
  ///  - samples are mirrored across the planes of symmetry: M_x and M_y are
  ///  even,
  ///    M_xy odd across both, Q_x odd across x = 0 and even across y = 0, Q_y
  ///    the other way round;
  ///  - at a vertex on an edge of the plate the patches of neighbouring
  ///  vertices
  ///    in the interior are used, averaged. So they are at hanging vertices:
  ///    the twelve samples of their three cells do determine eight terms, but
  ///    such a fit follows the error that it should expose (measured on a
  ///    simply supported plate: cells along a change of level then see half of
  ///    their error);
  ///  - a patch whose samples do not determine the polynomial grows by the
  ///  cells
  ///    around it: decided by rank, since 2x2 points in two cells side by side
  ///    are eight and determine six terms.
  class StressRecovery
  {
  public:
    static constexpr unsigned int n_terms = 8, n_resultants = 5,
                                  samples_per_cell = 4;

    /// @param mesh     of the plate with the ids of PlateBoundary; must outlive
    ///                 this object
    /// @param is_rough whether no polynomial fits across a point, as under a
    /// line
    ///                 load, where the shear force jumps: vertices there use
    ///                 their neighbours as on an edge
    explicit StressRecovery(
      const dealii::Triangulation<2>                      &mesh,
      const std::function<bool(const dealii::Point<2> &)> &is_rough = {});

    /// Coefficients of all patches from samples of n fields at once.
    /// @param samples  4 cell + point rows (cells by active index) by 5 n
    ///                 columns, resultant n + field
    /// @return 8 patch + term rows by 5 n columns
    RowMajorMatrix
    coefficients(const RowMajorMatrix &samples) const;

    /// Recovered resultants at points of a cell.
    /// @param unit_points  on the reference cell
    /// @param points       the same points on the plate [m]
    /// @param values       set to a row per point by 5 n columns
    void
    evaluate(unsigned int                         cell,
             const std::vector<dealii::Point<2>> &unit_points,
             const std::vector<dealii::Point<2>> &points,
             const RowMajorMatrix                &coefficients,
             RowMajorMatrix                      &values) const;

  private:
    /// An image of a cell in the plate unfolded across its planes of symmetry.
    struct Image
    {
      unsigned int cell;
      bool         mirrored_x, mirrored_y;

      bool
      operator<(const Image &other) const
      {
        return std::tie(cell, mirrored_x, mirrored_y) <
          std::tie(other.cell, other.mirrored_x, other.mirrored_y);
      }
    };

    struct Patch
    {
      dealii::Point<2>   centre;
      double             size;
      std::vector<Image> images;
      Eigen::MatrixXd    fit; ///< n_terms x number of samples
    };

    void
    mark_vertices(
      const std::function<bool(const dealii::Point<2> &)> &is_rough);
    void
    assign_patches();
    std::vector<Image>
    images_around(unsigned int vertex, const Image &seen_from) const;
    std::set<Image>
    grown(const std::set<Image> &images) const;
    Patch
    make_patch(unsigned int vertex) const;
    bool
    fit(Patch &patch) const;
    dealii::Point<2>
    sample_point(const Image &image, unsigned int point) const;

    const dealii::Triangulation<2> &mesh;

    std::vector<dealii::Point<2>>            sample_points;
    std::vector<std::vector<unsigned int>>   cells_at_vertex;
    std::vector<std::array<unsigned int, 4>> vertices_of_cell;
    std::vector<bool> is_on_symmetry_x, is_on_symmetry_y, uses_neighbours;

    std::vector<Patch>                     patches;
    std::vector<std::vector<unsigned int>> patches_of_vertex;
  };
} // namespace PlateImpact

#endif
