#ifndef plate_impact_scene_declarations_h
#define plate_impact_scene_declarations_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/scene/scene_schema.h"

namespace PlateImpact
{
  /// Declares every entry of a scene. The parameters must outlive the schema.
  void
  declare_parameters(SceneSchema &schema, Parameters &parameters);
} // namespace PlateImpact

#endif
