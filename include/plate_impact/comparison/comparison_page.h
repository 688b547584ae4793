#ifndef plate_impact_comparison_comparison_page_h
#define plate_impact_comparison_comparison_page_h

#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// comparison.html: who reaches which error first, errors against cells,
  /// unknowns and seconds, force histories over each other, meshes side by
  /// side, and what makes the comparison fair.
  class ComparisonPage
  {
  public:
    /// @param scene       must outlive the page, as all
    /// @param comparison  with a reference and curves
    ComparisonPage(const Scene                    &scene,
                   const StrategyComparison       &comparison,
                   const std::vector<std::string> &warnings);

    void
    write(std::ostream &out) const;

  private:
    void
    add_outcome(Page &page) const;
    void
    add_thresholds(Page &page) const;
    void
    add_meshes(Page &page) const;
    void
    add_fairness(Page &page) const;
    void
    add_numbers(Page &page) const;

    const Scene                    &scene;
    const StrategyComparison       &comparison;
    const std::vector<std::string> &warnings;
  };
} // namespace PlateImpact

#endif
