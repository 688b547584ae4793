#pragma once

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/estimator/error_estimator.h"

#include <string>
#include <vector>

namespace PlateImpact
{
  /// The active cells, sorted: equal for equal meshes of one initial mesh.
  std::vector<dealii::CellId>
  sorted_cells(const dealii::Triangulation<2> &mesh);


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
  /// Sizes are held at the vertices of the old mesh, the smallest that the
  /// cells there need, bilinear between them and limited in gradation.
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

  /// A mesh chosen before anything is known of its error: cells are at most
  /// theta r large, r the distance of their centre from the contact, down to
  /// the minimum cell size. The ratio theta is 1 first and halved from mesh to
  /// mesh.
  bool
  refine_graded(const Adapting &adapting);


  /// Refines cells until those at the load are no larger than its patch, or the
  /// thickness, and others no larger than their distance from it, or 5000 cells
  /// are too few for it.
  void
  refine_towards_load(dealii::Triangulation<2> &mesh,
                      const Parameters         &parameters);
} // namespace PlateImpact
