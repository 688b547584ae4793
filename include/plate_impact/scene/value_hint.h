#ifndef plate_impact_scene_value_hint_h
#define plate_impact_scene_value_hint_h

#include "plate_impact/base/entries.h"

#include <string>

namespace PlateImpact
{
  /// What to write in place of a value that an entry does not allow: a number
  /// with a unit in that of the entry ("8 mm": "; write 0.008"), a decimal
  /// comma as a point, another word for one that is allowed ("fixed": "; did
  /// you mean 'clamped'?"). Empty where nothing comes to mind.
  std::string
  hint_for(const std::string &value, const Entry &entry);
} // namespace PlateImpact

#endif
