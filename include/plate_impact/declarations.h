#ifndef plate_impact_declarations_h
#define plate_impact_declarations_h

#include "plate_impact/parameters.h"
#include "plate_impact/scene_schema.h"

#include <string>
#include <vector>

namespace PlateImpact
{
  /// What Adaptivity/Strategy may be.
  std::vector<std::string>
  adaptation_strategies();

  /// Declares every entry of a scene. The parameters must outlive the schema.
  void
  declare_parameters(SceneSchema &schema, Parameters &parameters);
} // namespace PlateImpact

#endif
