#ifndef plate_impact_output_console_h
#define plate_impact_output_console_h

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/analysis/outcome.h"
#include "plate_impact/base/text.h"
#include "plate_impact/output/progress_line.h"
#include "plate_impact/output/terminal.h"
#include "plate_impact/output/verdict.h"
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
    /// @param quiet  only warnings, errors and a line for scripts
    explicit Console(bool quiet);

    void
    begin(const Scene &scene);

    /// One line per mesh.
    void
    cycle(const CycleResult &result);

    void
    end(Outcome                         outcome,
        const CycleResult              &last,
        const Verdict                  &verdict,
        const std::vector<std::string> &warnings,
        const std::string              &results);

    /// Of the transient that is computed.
    ProgressLine progress;

  private:
    /// For scripts: peak force [N], bar relative to it, outcome, trust.
    void
    print_line(Outcome            outcome,
               const CycleResult &last,
               const Verdict     &verdict) const;

    const bool           quiet;
    const Terminal       out;
    AdaptivityParameters adaptivity = {};
    PrefixedUnit         time_unit  = {"s", 0.}; ///< for the end time
    std::string          local_response;         ///< in words
  };
} // namespace PlateImpact

#endif
