#ifndef plate_impact_output_console_h
#define plate_impact_output_console_h

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/analysis/outcome.h"
#include "plate_impact/base/text.h"
#include "plate_impact/output/progress_line.h"
#include "plate_impact/output/terminal.h"
#include "plate_impact/scene/scene.h"

#include <string>
#include <vector>

namespace PlateImpact
{
  /// What a user sees of a run. Results count more than that: a
  /// reader who closes the pipe (`| head`) does not end the run.
  class Console
  {
  public:
    /// @param quiet  only warnings and errors
    explicit Console(bool quiet);

    void
    begin(const Scene &scene);

    /// One line per mesh.
    void
    cycle(const CycleResult &result);

    void
    end(Outcome                         outcome,
        const CycleResult              &last,
        const std::vector<std::string> &warnings,
        const std::string              &results);

    /// Of the transient that is computed.
    ProgressLine progress;

  private:
    const bool           quiet;
    const Terminal       out;
    AdaptivityParameters adaptivity = {};
    PrefixedUnit         time_unit  = {"s", 0.}; ///< for the end time
    std::string          local_response;         ///< in words
  };
} // namespace PlateImpact

#endif
