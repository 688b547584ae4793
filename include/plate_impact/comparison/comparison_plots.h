#ifndef plate_impact_comparison_comparison_plots_h
#define plate_impact_comparison_comparison_plots_h

#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <functional>
#include <vector>

namespace PlateImpact
{
  /// What comparison.html plots. Each function adds a section to the page.
  class ComparisonPlots
  {
  public:
    /// @param scene       must outlive the plots, as the comparison
    /// @param comparison  with a reference and curves
    ComparisonPlots(const Scene &scene, const StrategyComparison &comparison);

    /// Errors of the peak force and eta against cells, unknowns and seconds.
    void
    add_costs(Page &page) const;

    /// Nothing where the scene gives the reference: it has no fields then.
    void
    add_effectivity(Page &page) const;

    void
    add_histories(Page &page) const;

  private:
    /// An empty series with the name and colour of the strategy.
    Series
    series(const ComparisonCurve &curve) const;
    /// A plot for every element with a series for every strategy.
    std::vector<Plot>
    plots_by_element(
      const Plot                                                   &frame,
      const std::function<void(const ComparisonCurve &, Series &)> &fill) const;
    void
    add_uncertainty(Plot &plot) const;

    const Scene              &scene;
    const StrategyComparison &comparison;
  };
} // namespace PlateImpact

#endif
