#ifndef plate_impact_report_h
#define plate_impact_report_h

#include "plate_impact/scene.h"

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// The run on one self-contained page: outcome, cycles, meshes and scene.
  /// @param cycles    as in summary.json
  /// @param pictures  SVG of the mesh of each cycle
  void
  write_report(std::ostream                   &out,
               const Scene                    &scene,
               const std::string              &outcome,
               const std::vector<std::string> &warnings,
               const nlohmann::ordered_json   &cycles,
               const std::vector<std::string> &pictures);
} // namespace PlateImpact

#endif
