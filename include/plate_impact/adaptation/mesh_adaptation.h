#ifndef plate_impact_adaptation_mesh_adaptation_h
#define plate_impact_adaptation_mesh_adaptation_h

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


  /// A way to make the mesh follow its error: the strategy that the scene
  /// names.
  class MeshAdaptation
  {
  public:
    /// @param contact_half_length  l of a contact along 0 <= x <= l; 0 for a
    ///                             sphere [m]
    explicit MeshAdaptation(const AdaptivityParameters &adaptivity,
                            double contact_half_length = 0.)
      : adaptivity(adaptivity)
      , contact_half_length(contact_half_length)
    {}

    /// Changes the mesh.
    /// @param warnings  told what a user should know about the new mesh
    /// @return whether the new mesh differs from the old one
    /// @throws ComputationError when there is no new mesh
    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorRatios        &error,
          std::vector<std::string> &warnings) const;

    /// About how many cells the mesh would have after adapt(); as many as now
    /// of strategies that refine cells once, whose mesh can be made and
    /// counted.
    double
    n_wanted_cells(const dealii::Triangulation<2> &mesh,
                   const ErrorRatios              &error) const;

  private:
    const AdaptivityParameters adaptivity;
    const double               contact_half_length;
  };


  // Strategies, each as MeshAdaptation::adapt().

  /// Satisfies target sizes by refining and coarsening cells of the given mesh,
  /// several levels at once where necessary. Levels are rounded up, so that no
  /// cell stays larger than its target.
  bool
  adapt_by_hanging_nodes(dealii::Triangulation<2>   &mesh,
                         const ErrorRatios          &error,
                         const AdaptivityParameters &adaptivity,
                         double                      contact_half_length,
                         std::vector<std::string>   &warnings);

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
  remesh(dealii::Triangulation<2>   &mesh,
         const ErrorRatios          &error,
         const AdaptivityParameters &adaptivity,
         double                      contact_half_length,
         std::vector<std::string>   &warnings);

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
  refine_graded(dealii::Triangulation<2>   &mesh,
                const ErrorRatios          &error,
                const AdaptivityParameters &adaptivity,
                double                      contact_half_length,
                std::vector<std::string>   &warnings);


  /// Refines cells until those at the load are no larger than its patch, or the
  /// thickness, and others no larger than their distance from it, or 5000 cells
  /// are too few for it.
  void
  refine_towards_load(dealii::Triangulation<2> &mesh,
                      const Parameters         &parameters);
} // namespace PlateImpact

#endif
