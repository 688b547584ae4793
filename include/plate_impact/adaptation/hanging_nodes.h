#ifndef plate_impact_adaptation_hanging_nodes_h
#define plate_impact_adaptation_hanging_nodes_h

#include "plate_impact/adaptation/mesh_adaptation.h"

namespace PlateImpact
{
  /// Satisfies target sizes by refining and coarsening cells of the given mesh,
  /// several levels at once where necessary. Levels are rounded up, so that no
  /// cell stays larger than its target.
  class HangingNodeAdaptation : public MeshAdaptation
  {
  public:
    using MeshAdaptation::MeshAdaptation;

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorRatios        &error,
          std::vector<std::string> &warnings) const override;

  protected:
    std::vector<double>
    wanted_sizes(const dealii::Triangulation<2> &mesh,
                 const ErrorRatios              &error) const override;
  };
} // namespace PlateImpact

#endif
