#ifndef plate_impact_adaptation_mesh_adaptation_h
#define plate_impact_adaptation_mesh_adaptation_h

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/estimator/error_estimator.h"

#include <memory>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// Sizes that follow from the error of each cell (Table 1 of the paper),
  /// h_new = h / xi'^phi, infinite without an error. By active index. Whether
  /// a cell is coarsened is decided on these, its size by allowed_size(). [m]
  std::vector<double>
  target_sizes(const dealii::Triangulation<2> &mesh,
               const ErrorRatios              &error,
               const AdaptivityParameters     &adaptivity);

  /// The size nearest to one that is wanted, between the minimum and the
  /// maximum cell size; where the minimum is the larger one, the maximum. [m]
  double
  allowed_size(double size, const AdaptivityParameters &adaptivity);

  /// About how many cells have the area of the mesh when each gives way to
  /// cells of the allowed size next to its target, by active index [m].
  double
  n_cells_of_sizes(const dealii::Triangulation<2> &mesh,
                   const std::vector<double>      &sizes,
                   const AdaptivityParameters     &adaptivity);

  /// Whether the minimum cell size forbids to refine a cell.
  bool
  is_smallest(const dealii::Triangulation<2>::cell_iterator &cell,
              const AdaptivityParameters                    &adaptivity);


  /// The active cells, sorted: equal for equal meshes of one initial mesh.
  std::vector<dealii::CellId>
  sorted_cells(const dealii::Triangulation<2> &mesh);


  /// A way to make the mesh follow its error.
  class MeshAdaptation
  {
  public:
    /// @param contact_half_length  l of a contact along 0 <= x <= l; 0 for a
    ///                             sphere [m]
    MeshAdaptation(const AdaptivityParameters &adaptivity,
                   double                      contact_half_length);

    virtual ~MeshAdaptation() = default;

    /// Changes the mesh.
    /// @param warnings  told what a user should know about the new mesh
    /// @return whether the new mesh differs from the old one
    /// @throws ComputationError when there is no new mesh
    virtual bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorRatios        &error,
          std::vector<std::string> &warnings) const = 0;

    /// About how many cells the mesh would have after adapt(), by
    /// wanted_sizes(); without those as many as now.
    double
    n_wanted_cells(const dealii::Triangulation<2> &mesh,
                   const ErrorRatios              &error) const;

  protected:
    /// Sizes of cells that take the place of the present ones, by active index;
    /// none by default, for strategies that refine cells once, whose mesh can
    /// be made and counted. [m]
    virtual std::vector<double>
    wanted_sizes(const dealii::Triangulation<2> &mesh,
                 const ErrorRatios              &error) const;

    const AdaptivityParameters adaptivity;
    const double               contact_half_length;
  };


  /// The strategy that the scene names; `none` keeps the mesh.
  std::unique_ptr<const MeshAdaptation>
  make_mesh_adaptation(const AdaptivityParameters &adaptivity,
                       double                      contact_half_length = 0.);
} // namespace PlateImpact

#endif
