#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/output/run_in_words.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// Columns of a history for a page, by their names in contact_history.csv:
  /// every so many of its states, so that there are no more than a plot shows,
  /// with the last and that of the largest force.
  /// @param columns  all, and `total_energy`, when left out
  Json
  history_on_page(const ContactHistory           &history,
                  std::size_t                     most_states,
                  const std::vector<std::string> &columns = {});

  /// report.html: a run on one page. Takes what it shows cycle by cycle, since
  /// the meshes do not stay.
  class Report
  {
  public:
    void
    add_cycle(const Cycle &cycle);

    /// Once, at the end.
    /// @param summary  the content of summary.json
    /// @param last     for the film of the deflection
    void
    write(std::ostream  &out,
          const Scene   &scene,
          const Verdict &verdict,
          const Json    &summary,
          const Cycle   &last);

  private:
    Json histories = Json::array(), errors = Json::array(),
         meshes = Json::array(), stresses = Json::array();
  };
} // namespace PlateImpact
