#ifndef plate_impact_console_h
#define plate_impact_console_h

#include "plate_impact/comparison.h"
#include "plate_impact/cycle_result.h"
#include "plate_impact/prefixed_unit.h"
#include "plate_impact/scene.h"
#include "plate_impact/terminal.h"

#include <chrono>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What a user sees while the program runs. Results count more than that: a
  /// reader who closes the pipe (`| head`) does not end the run.
  class Console
  {
  public:
    /// @param quiet  only warnings and errors
    explicit Console(bool quiet);

    ~Console();

    void
    begin(const Scene &scene);

    /// A line that is overwritten, with the time that the rest of the transient
    /// takes; on a terminal and within long transients only.
    void
    progress(unsigned int cycle, unsigned int step, unsigned int n_steps);

    /// One line per mesh.
    void
    cycle(const CycleResult &result);

    void
    begin_comparison(const Scene &scene);

    void
    reference(const Reference &reference);

    /// The last mesh of a curve.
    void
    compared_mesh(const ComparisonCurve &curve);

    void
    curve_end(const ComparisonCurve &curve);

    void
    end_comparison(const std::vector<ThresholdRow> &rows,
                   const std::vector<std::string>  &warnings,
                   const std::string               &results);

    void
    end(const std::string              &outcome,
        const CycleResult              &last,
        const std::vector<std::string> &warnings,
        const std::string              &results);

  private:
    void
    clear_progress();
    void
    warn(const std::vector<std::string> &warnings) const;

    using Clock = std::chrono::steady_clock;

    const bool        quiet;
    const Terminal    out, err;
    double            target            = 0.;        ///< eta that is asked for
    PrefixedUnit      time_unit         = {"s", 0.}; ///< for the end time
    bool              has_progress      = false;
    unsigned int      cycle_in_progress = 0;
    Clock::time_point begin_of_transient, last_progress;
  };
} // namespace PlateImpact

#endif
