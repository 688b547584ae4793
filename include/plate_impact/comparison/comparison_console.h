#ifndef plate_impact_comparison_comparison_console_h
#define plate_impact_comparison_comparison_console_h

#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/output/progress_line.h"
#include "plate_impact/output/terminal.h"
#include "plate_impact/scene/scene.h"

#include <chrono>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What a user sees of a comparison.
  class ComparisonConsole
  {
  public:
    /// @param quiet  only warnings and errors
    explicit ComparisonConsole(bool quiet);

    void
    begin(const Scene &scene);

    void
    reference(const Reference &reference);

    /// Before a curve: which of how many, and the time that is left.
    void
    curve(const ComparedStrategy &strategy, ElementType element);

    /// The last mesh of a curve.
    void
    mesh(const ComparisonCurve &curve);

    void
    curve_end(const ComparisonCurve &curve);

    void
    end(const std::vector<ThresholdRow> &rows,
        const std::vector<std::string>  &warnings,
        const std::string               &results);

    /// Of the transient that is computed.
    ProgressLine progress;

  private:
    using Clock = std::chrono::steady_clock;

    const bool        quiet;
    const Terminal    out;
    std::size_t       n_curves = 0, n_curves_begun = 0;
    Clock::time_point begin_of_curves;
  };
} // namespace PlateImpact

#endif
