#ifndef plate_impact_console_h
#define plate_impact_console_h

#include "plate_impact/cycle_result.h"
#include "plate_impact/scene.h"

#include <chrono>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What a user sees while the program runs.
  class Console
  {
  public:
    /// @param quiet  only warnings and errors
    explicit Console(bool quiet);

    void
    begin(const Scene &scene);

    /// A line that is overwritten, on a terminal and within long transients
    /// only.
    void
    progress(unsigned int cycle, unsigned int step, unsigned int n_steps);

    /// One line per mesh.
    void
    cycle(const CycleResult &result);

    void
    end(const std::string              &outcome,
        const CycleResult              &last,
        const std::vector<std::string> &warnings,
        const std::string              &results);

  private:
    void
    clear_progress();

    const bool                            quiet, shows_progress;
    bool                                  has_progress = false;
    std::chrono::steady_clock::time_point last_progress;
  };
} // namespace PlateImpact

#endif
