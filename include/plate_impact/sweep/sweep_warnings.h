#ifndef plate_impact_sweep_sweep_warnings_h
#define plate_impact_sweep_sweep_warnings_h

#include "plate_impact/sweep/sweep_table.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What a user should know about the rows of a sweep: how many points failed,
  /// and how many have warnings that differ in their numbers only, with the
  /// first of each kind.
  std::vector<std::string>
  sweep_warnings(const std::vector<std::optional<SweepRow>> &rows);
} // namespace PlateImpact

#endif
