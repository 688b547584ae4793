#ifndef plate_impact_adaptation_graded_refinement_h
#define plate_impact_adaptation_graded_refinement_h

#include "plate_impact/adaptation/mesh_adaptation.h"

namespace PlateImpact
{
  /// A mesh chosen before anything is known of its error: cells are at most
  /// theta r large, r the distance of their centre from the contact, down to
  /// the minimum cell size. The ratio theta is 1 first and halved from mesh to
  /// mesh.
  class GradedRefinement : public MeshAdaptation
  {
  public:
    using MeshAdaptation::MeshAdaptation;

    bool
    adapt(dealii::Triangulation<2> &mesh,
          const ErrorRatios        &error,
          std::vector<std::string> &warnings) const override;
  };


  /// Refines cells until those at the load are no larger than its patch, or the
  /// thickness, and others no larger than their distance from it, or 5000 cells
  /// are too few for it.
  void
  refine_towards_load(dealii::Triangulation<2> &mesh,
                      const Parameters         &parameters);
} // namespace PlateImpact

#endif
