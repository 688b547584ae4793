#ifndef plate_impact_comparison_comparison_console_h
#define plate_impact_comparison_comparison_console_h

#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/output/progress_line.h"
#include "plate_impact/output/terminal.h"
#include "plate_impact/scene/scene.h"

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
    const bool     quiet;
    const Terminal out;
  };
} // namespace PlateImpact

#endif
