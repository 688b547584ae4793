#include "plate_impact/adaptation/make_mesh_adaptation.h"

#include "plate_impact/adaptation/graded_refinement.h"
#include "plate_impact/adaptation/hanging_nodes.h"
#include "plate_impact/adaptation/ranked_refinement.h"
#include "plate_impact/adaptation/remeshing.h"
#include "plate_impact/adaptation/uniform_refinement.h"

#include <stdexcept>

namespace PlateImpact
{
  std::unique_ptr<const MeshAdaptation>
  make_mesh_adaptation(const AdaptivityParameters &adaptivity,
                       const double                contact_half_length)
  {
    switch (adaptivity.strategy)
      {
        case AdaptationStrategy::none:
          return std::make_unique<KeptMesh>();
        case AdaptationStrategy::hanging_nodes:
          return std::make_unique<HangingNodeAdaptation>(adaptivity);
        case AdaptationStrategy::uniform:
          return std::make_unique<UniformRefinement>(adaptivity);
        case AdaptationStrategy::remeshing:
          return std::make_unique<Remeshing>(adaptivity, contact_half_length);
        case AdaptationStrategy::graded:
          return std::make_unique<GradedRefinement>(adaptivity,
                                                    contact_half_length);
        case AdaptationStrategy::fixed_fraction:
          return std::make_unique<FixedFraction>(adaptivity);
        case AdaptationStrategy::fixed_number:
          return std::make_unique<FixedNumber>(adaptivity);
      }
    throw std::logic_error("no such strategy");
  }
} // namespace PlateImpact
