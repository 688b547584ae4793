#ifndef plate_impact_mesh_adaptation_h
#define plate_impact_mesh_adaptation_h

#include <deal.II/grid/tria.h>

#include "plate_impact/error_estimator.h"
#include "plate_impact/parameters.h"

#include <memory>
#include <vector>

namespace PlateImpact
{
  /// Sizes that the error of each cell asks for (Table 1 of the paper),
  /// h_new = h / xi'^phi, not below the minimum cell size. By active index. [m]
  std::vector<double>
  target_sizes(const dealii::Triangulation<2> &mesh,
               const ErrorEstimate            &estimate,
               const AdaptivityParameters     &adaptivity);

  /// Whether the minimum cell size forbids to refine a cell.
  bool
  is_smallest(const dealii::Triangulation<2>::cell_iterator &cell,
              const AdaptivityParameters                    &adaptivity);


  /// A way to make the mesh follow its error.
  class MeshAdaptation
  {
  public:
    virtual ~MeshAdaptation() = default;

    /// Changes the mesh.
    /// @return whether the new mesh differs from the old one
    virtual bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorEstimate      &estimate) const = 0;
  };


  /// Satisfies target sizes by refining and coarsening cells of the given mesh,
  /// several levels at once where asked for. Levels are rounded up, so that no
  /// cell stays larger than its target.
  class HangingNodeAdaptation : public MeshAdaptation
  {
  public:
    explicit HangingNodeAdaptation(const AdaptivityParameters &adaptivity);

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorEstimate      &estimate) const override;

  private:
    const AdaptivityParameters adaptivity;
  };


  /// Halves every cell, whatever its error, unless one is at the minimum size.
  class UniformRefinement : public MeshAdaptation
  {
  public:
    explicit UniformRefinement(const AdaptivityParameters &adaptivity);

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorEstimate      &estimate) const override;

  private:
    const AdaptivityParameters adaptivity;
  };


  /// The strategy that the scene names; null for `none`.
  std::unique_ptr<const MeshAdaptation>
  make_mesh_adaptation(const AdaptivityParameters &adaptivity);
} // namespace PlateImpact

#endif
