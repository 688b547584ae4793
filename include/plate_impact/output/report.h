#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/output/run_in_words.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <string>

namespace PlateImpact
{
  /// A history for a page: every so many of its states, with the last and that
  /// of the largest force.
  /// @param has_all  displacements and energies besides `time` and `force`
  Json
  history_on_page(const ContactHistory &history, bool has_all = false);

  /// Adds what report.html shows of a cycle, since the meshes do not stay, to
  /// its lists: `histories`, `errors`, `meshes`, `stresses`.
  void
  add_to_report(const Cycle &cycle, Json &study);

  /// report.html: a run on one page.
  /// @param last   for the film of the deflection
  /// @param study  with all cycles, the text of the scene and summary.json
  std::string
  report(const Scene   &scene,
         const Verdict &verdict,
         const Cycle   &last,
         Json           study);
} // namespace PlateImpact
