#pragma once

#include "plate_impact/base/parameters.h"

#include <string>

namespace PlateImpact
{
  /// The scene in a sentence.
  std::string
  scene_in_words(const Parameters &parameters);

  /// The local response under the contact, and why where it is the only one
  /// that fits. For scenes with an impactor.
  std::string
  local_response_in_words(const Parameters &parameters);

  /// How the contact force is spread, and what that means for its limit.
  std::string
  load_in_words(const Parameters &parameters);
} // namespace PlateImpact
