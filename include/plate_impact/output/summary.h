#ifndef plate_impact_output_summary_h
#define plate_impact_output_summary_h

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/base/parameters.h"

#include <nlohmann/json.hpp>

#include <string>

namespace PlateImpact
{
  /// What summary.json says of a cycle (doc/results.md has every key).
  nlohmann::ordered_json
  summary_of(const CycleResult &result, const Parameters &parameters);

  /// Every entry of a scene by its path, from the text of the scene.
  nlohmann::ordered_json
  inputs_of(const std::string &text);
} // namespace PlateImpact

#endif
