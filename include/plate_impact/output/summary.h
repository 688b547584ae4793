#ifndef plate_impact_output_summary_h
#define plate_impact_output_summary_h

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/page/page.h"

#include <optional>
#include <string>

namespace PlateImpact
{
  /// What summary.json says of a cycle (doc/results.md has every key).
  /// @param expected  empty without an impactor
  Json
  summary_of(const CycleResult                &result,
             const Parameters                 &parameters,
             const std::optional<ZenerImpact> &expected);

  /// Every entry of a scene by its path, from the text of the scene.
  Json
  inputs_of(const std::string &text);
} // namespace PlateImpact

#endif
