#ifndef plate_impact_sweep_sweep_page_h
#define plate_impact_sweep_sweep_page_h

#include "plate_impact/contact/contact_history.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/sweep_scene.h"
#include "plate_impact/sweep/sweep_computation.h"
#include "plate_impact/sweep/sweep_plots.h"
#include "plate_impact/sweep/sweep_table.h"

#include <cstddef>
#include <iosfwd>
#include <map>
#include <optional>
#include <vector>

namespace PlateImpact
{
  /// sweep.html: the range of the force, the scene in words, plots, histories
  /// and the table.
  class SweepPage
  {
  public:
    /// @param rows       of all points; must outlive the page
    /// @param histories  of some points; likewise
    SweepPage(const SweepScene                            &scene,
              const std::vector<std::optional<SweepRow>>  &rows,
              const std::map<std::size_t, ContactHistory> &histories);

    void
    write(std::ostream &out, const SweepWork &work) const;

  private:
    void
    write_facts(Page &page, const SweepWork &work) const;
    void
    write_table(Page &page) const;

    const SweepScene                           &scene;
    const SweepPlan                            &plan;
    const std::vector<std::optional<SweepRow>> &rows;
    const SweepPlots                            plots;
  };
} // namespace PlateImpact

#endif
