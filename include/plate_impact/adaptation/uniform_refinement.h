#ifndef plate_impact_adaptation_uniform_refinement_h
#define plate_impact_adaptation_uniform_refinement_h

#include "plate_impact/adaptation/mesh_adaptation.h"

namespace PlateImpact
{
  /// Halves every cell, whatever its error, unless one is at the minimum size.
  class UniformRefinement : public MeshAdaptation
  {
  public:
    explicit UniformRefinement(const AdaptivityParameters &adaptivity);

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorOverLimit     &error,
          std::vector<std::string> &warnings) const override;

  private:
    const AdaptivityParameters adaptivity;
  };
} // namespace PlateImpact

#endif
