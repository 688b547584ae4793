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
    explicit HangingNodeAdaptation(const AdaptivityParameters &adaptivity);

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorOverLimit     &error,
          std::vector<std::string> &warnings) const override;

    double
    n_wanted_cells(const dealii::Triangulation<2> &mesh,
                   const ErrorOverLimit           &error) const override;

  private:
    const AdaptivityParameters adaptivity;
  };
} // namespace PlateImpact

#endif
