#ifndef plate_impact_sweep_sweep_plots_h
#define plate_impact_sweep_sweep_plots_h

#include "plate_impact/contact/contact_history.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/sweep_plan.h"
#include "plate_impact/sweep/sweep_table.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What sweep.html plots: the figures of the points over the swept values.
  /// Curves over one entry, or over the first where lists are paired up;
  /// coloured maps over two, or a curve for each value where one of them has
  /// few values or words; over three, such a figure for each value of the
  /// third, on one scale. Each function that adds adds a section to the page.
  class SweepPlots
  {
  public:
    /// More histories than these do not show in one plot.
    static constexpr std::size_t max_histories = 12;

    /// @param plan       must outlive the plots, as the rest
    /// @param rows       of all points
    /// @param histories  of some points
    SweepPlots(const SweepPlan                             &plan,
               const std::vector<std::optional<SweepRow>>  &rows,
               const std::map<std::size_t, ContactHistory> &histories);

    void
    add_figures(Page &page) const;

    /// Forces against time; nothing without histories.
    void
    add_histories(Page &page) const;

    /// And where they are.
    std::vector<Fact>
    smallest_and_largest_force() const;

  private:
    /// An entry as an axis.
    struct Scale
    {
      std::string              title;
      bool                     is_numeric;
      std::vector<std::string> texts;
      std::vector<double>      values; ///< numbers 1, 2, ... for words
    };

    /// A figure as a quantity of a plot: its index, title with unit, and factor
    /// to that unit.
    struct Quantity
    {
      std::size_t index;
      std::string title;
      double      factor;
    };

    /// A quantity over the product of the first two entries.
    struct Panel
    {
      const Quantity *quantity;
      std::string     title;  ///< what tells it from others of the quantity
      std::size_t     first;  ///< point
      std::size_t     stride; ///< to the next value of the second entry
    };

    std::vector<Quantity>
    quantities() const;
    Scale
    scale(const SweptEntry &entry) const;
    /// The value of a quantity at a point, NaN where there is none.
    double
    value(const Quantity &quantity, std::size_t point) const;
    /// Of its values at all points.
    Range
    range(const Quantity &quantity) const;

    /// As maps, or as families of curves.
    void
    add_panels(Page &page, const std::vector<Panel> &panels, bool small) const;
    Plot
    curves(const Quantity                              &quantity,
           const Scale                                 &x,
           const std::vector<std::string>              &names,
           const std::vector<std::vector<std::size_t>> &points) const;
    /// Points whose impacts have warnings, as dots of their own.
    void
    mark_warnings(const Quantity                              &quantity,
                  const Scale                                 &x,
                  const std::vector<std::vector<std::size_t>> &points,
                  Plot                                        &plot) const;

    const SweepPlan                             &plan;
    const std::vector<std::optional<SweepRow>>  &rows;
    const std::map<std::size_t, ContactHistory> &histories;
    const std::vector<Quantity>                  shown;
  };
} // namespace PlateImpact

#endif
