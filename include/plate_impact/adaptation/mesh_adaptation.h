#pragma once

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/estimator/energy_norm_estimator.h"

#include <algorithm>
#include <string>
#include <vector>

namespace PlateImpact
{
  // Sizes of cells.

  /// Sizes that follow from the error of each cell (Table 1 of the paper),
  /// h_new = h / xi'^phi with phi = CellSizing::exponent, infinite without an
  /// error. By active index. Whether a cell is coarsened is decided on these,
  /// its size by CellSizing::allowed(). [m]
  std::vector<double>
  target_sizes(const dealii::Triangulation<2> &mesh,
               const ErrorRatios              &error,
               const AdaptivityParameters     &adaptivity);

  /// What a scene says of the size of a cell.
  struct CellSizing
  {
    CellSizing(const dealii::Triangulation<2>::cell_iterator &cell,
               const AdaptivityParameters                    &adaptivity);

    /// The size nearest to one that is wanted, between the minimum and the
    /// maximum; where the minimum is the larger one, the maximum. [m]
    double
    allowed(const double size) const
    {
      return std::clamp(size, std::min(minimum, maximum), maximum);
    }

    /// The size at a place in a cell which needs the given one: the same, but
    /// where it touches a singular point growing with the distance from that,
    /// so that new cells have errors alike. [m]
    double
    at(const dealii::Point<2> &position, double size) const;

    /// The strongest of the singular points that the cell touches, or null.
    const SingularPoint *singular = nullptr;

    /// phi: that of the scene, 1/p, or 1/lambda in a cell that touches a
    /// singular point of strength lambda, whose error falls with h^lambda
    /// (Table 1 of the paper; Zienkiewicz & Zhu 1987,
    /// doi:10.1002/nme.1620240206) and four at most.
    double exponent;

    /// Of the scene; where the program has chosen it, for the load, a millionth
    /// of it at other singular points. [m]
    double minimum;

    double maximum; ///< [m]

    /// q in h(r) ~ r^q, by which cells around the singular point have equal
    /// errors: that of a cell at a distance r is as h^{p+1} r^{lambda-1-p}.
    double grading = 0.;
  };


  /// About how many cells have the area of the mesh when each gives way to
  /// cells of the allowed size next to its target, by active index [m].
  double
  n_cells_of_sizes(const dealii::Triangulation<2> &mesh,
                   const std::vector<double>      &sizes,
                   const AdaptivityParameters     &adaptivity);

  /// Raises errors so that no cell has a larger target than as many equal cells
  /// as all targets ask for would have, or half as many as there are.
  /// @return whether a cell is larger than that
  bool
  equalize(const dealii::Triangulation<2> &mesh,
           ErrorRatios                    &error,
           const AdaptivityParameters     &adaptivity);

  /// Whether the minimum cell size forbids to refine a cell.
  bool
  is_smallest(const dealii::Triangulation<2>::cell_iterator &cell,
              const AdaptivityParameters                    &adaptivity);


  /// The active cells, sorted: equal for equal meshes of one initial mesh.
  inline std::vector<dealii::CellId>
  sorted_cells(const dealii::Triangulation<2> &mesh)
  {
    std::vector<dealii::CellId> cells;
    for (const auto &cell : mesh.active_cell_iterators())
      cells.push_back(cell->id());
    std::sort(cells.begin(), cells.end());
    return cells;
  }


  /// A mesh that is made to follow its error, and what that takes.
  struct Adapting
  {
    dealii::Triangulation<2>   &mesh;
    const ErrorRatios          &error;
    const AdaptivityParameters &adaptivity;

    /// l of a contact along 0 <= x <= l; 0 for a sphere. [m]
    double contact_half_length;

    /// Told what a user should know about the new mesh.
    std::vector<std::string> &warnings;
  };


  /// Changes the mesh by the strategy that the scene names.
  /// @return whether the new mesh differs from the old one
  /// @throws ComputationError when there is no new mesh
  bool
  adapt_mesh(const Adapting &adapting);

  /// About how many cells the mesh would have after that; as many as now of
  /// strategies that refine cells once, whose mesh can be made and counted.
  double
  n_wanted_cells(const dealii::Triangulation<2> &mesh,
                 const ErrorRatios              &error,
                 const AdaptivityParameters     &adaptivity);


  // Strategies, each as adapt_mesh().

  /// Satisfies target sizes by refining and coarsening cells of the given mesh,
  /// several levels at once where necessary. Levels are rounded up, so that no
  /// cell stays larger than its target.
  bool
  adapt_by_hanging_nodes(const Adapting &adapting);

  /// Satisfies target sizes by a new mesh of quadrilaterals, as the paper does.
  /// The impact and the end of a line contact are vertices.
  ///
  /// Gmsh's cells scatter around their size, and xi' with its square, so that
  /// without more half of the cells would exceed their limit for ever: cells to
  /// be refined get somewhat less than they need, and cells grow only when
  /// their target is well above them. For the same reason a mesh is kept when
  /// eta is met and no cell is off its target by more than the scatter.
  bool
  remesh(const Adapting &adapting);

  /// By active index. [m]
  std::vector<double>
  sizes_for_remeshing(const dealii::Triangulation<2> &mesh,
                      const ErrorRatios              &error,
                      const AdaptivityParameters     &adaptivity);

  /// A mesh of as many cells along the sides. For the goal of the peak force
  /// cells are refined until those at the load are no larger than its patch, or
  /// the thickness, and others no larger than their distance from it, or 5000
  /// more cells are too few for it.
  std::unique_ptr<dealii::Triangulation<2>>
  make_first_mesh(const Parameters                  &parameters,
                  const std::array<unsigned int, 2> &n_cells);

  /// Whether a mesh may give way to such a mesh of other numbers of cells: that
  /// of a rectangle or circle, with hanging nodes.
  bool
  may_have_equal_cells(const Parameters &parameters);

  /// Refines cells that are larger than theta times their distance from the
  /// contact, or than cells may be, again and again, as long as the maximum of
  /// cells allows it.
  /// @return whether the mesh is refined
  bool
  refine_to_contact(dealii::Triangulation<2>   &mesh,
                    double                      theta,
                    const AdaptivityParameters &adaptivity,
                    double                      contact_half_length);
} // namespace PlateImpact
