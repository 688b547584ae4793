#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/output/run_in_words.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <functional>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace PlateImpact
{
  /// What a history has over time, by names.
  using HistoryColumns = std::vector<
    std::pair<std::string, std::function<double(const ContactState &)>>>;

  /// Columns of a history for a page: of every so many of its states, with the
  /// last and that of the largest force.
  Json
  history_on_page(
    const ContactHistory &history,
    const HistoryColumns &columns = {{"time", &ContactState::time},
                                     {"force", &ContactState::force}});

  /// Adds what report.html shows of a cycle, since the meshes do not stay, to
  /// its lists: `histories`, `errors`, `meshes`, `stresses`.
  void
  add_to_report(const Cycle &cycle, Json &study);

  /// report.html: a run on one page.
  /// @param summary  the content of summary.json
  /// @param last     for the film of the deflection
  /// @param study    with all cycles
  void
  write_report(std::ostream  &out,
               const Scene   &scene,
               const Verdict &verdict,
               const Json    &summary,
               const Cycle   &last,
               Json           study);
} // namespace PlateImpact
