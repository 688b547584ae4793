#include "plate_impact/sweep/sweep_plots.h"

#include "plate_impact/analysis/impact_figures.h"
#include "plate_impact/base/entries.h"
#include "plate_impact/base/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// An entry with up to so many values has a curve for each.
    constexpr std::size_t most_curves = 8;

    /// Values of a third entry with figures of their own.
    constexpr std::size_t most_panels = 8;

    /// Points of a map that a browser draws without delay.
    constexpr std::size_t most_map_points = 40000;

    /// The figures that are plotted, where points have them.
    const std::vector<std::string> plotted = {"peak_force",
                                              "first_contact_end",
                                              "coefficient_of_restitution",
                                              "max_plate_displacement",
                                              "number_of_contacts",
                                              "peak_force_over_zener",
                                              "discretization_error"};



    /// Of a title "Peak force [N]": "Peak force".
    std::string
    without_unit(const std::string &title)
    {
      return title.substr(0, title.find(" ["));
    }



    /// Of a title "Peak force [N]": "[N]"; empty for a pure number.
    std::string
    unit_of(const std::string &title)
    {
      const std::size_t bracket = title.find('[');
      return bracket == title.npos ? "" : title.substr(bracket);
    }



    /// "Velocity = 2 m/s" with " = " between name and value.
    std::string
    assignment(const SweptEntry  &entry,
               const std::string &value,
               const std::string &between)
    {
      return entry.path.substr(entry.path.find('/') + 1) + between + value +
        (entry.unit.empty() || entry.unit == "-" ? "" : ' ' + entry.unit);
    }
  } // namespace



  SweepPlots::SweepPlots(const SweepPlan                             &plan,
                         const std::vector<std::optional<SweepRow>>  &rows,
                         const std::map<std::size_t, ContactHistory> &histories)
    : plan(plan)
    , rows(rows)
    , histories(histories)
    , shown(quantities())
  {}



  void
  SweepPlots::add_figures(Page &page) const
  {
    page.section("Figures");
    const std::vector<SweptEntry> &entries = plan.entries();
    if (entries.size() == 1 || !plan.forms_product())
      {
        std::vector<std::size_t> points(rows.size());
        for (std::size_t point = 0; point < rows.size(); ++point)
          points[point] = point;
        std::vector<Plot> plots;
        for (const Quantity &quantity : shown)
          plots.push_back(curves(quantity, scale(entries[0]), {""}, {points}));
        return page.plots(plots);
      }

    const std::size_t n_third =
      entries.size() == 2 ? 1 : entries[2].values.size();
    const std::size_t n_shown = std::min(n_third, most_panels);
    const std::size_t most_quantities =
      std::max<std::size_t>(1,
                            most_map_points * n_third /
                              (rows.size() * n_shown));
    std::vector<Panel> panels;
    for (std::size_t q = 0; q < std::min(shown.size(), most_quantities); ++q)
      {
        for (std::size_t k = 0; k < n_shown; ++k)
          panels.push_back(
            {&shown[q],
             entries.size() == 2 ?
               "" :
               assignment(entries[2], entries[2].values[k], " = "),
             k,
             n_third});
        if (entries.size() == 2)
          continue;
        page.heading(without_unit(shown[q].title));
        add_panels(page, panels, /*small=*/true);
        panels.clear();
      }
    if (entries.size() == 2)
      add_panels(page, panels, /*small=*/false);
    if (n_shown < n_third)
      page.paragraph("The other " + std::to_string(n_third - n_shown) +
                     " values of " + entries[2].path + " are in sweep.csv.");
  }



  void
  SweepPlots::add_histories(Page &page) const
  {
    if (histories.empty())
      return;
    double peak = 0., end = 0.;
    for (const auto &[point, history] : histories)
      {
        peak = std::max(peak, history.peak().force);
        end  = std::max(end, history.states().back().time);
      }
    const PrefixedUnit newton("N", peak), second("s", end);
    Plot               plot;
    plot.title   = "Force against time";
    plot.x.title = "time [" + second.name() + "]";
    plot.y.title = "force [" + newton.name() + "]";
    for (const auto &[point, history] : histories)
      {
        Series series;
        for (const std::string &value : plan.values(point))
          series.name += (series.name.empty() ? "" : ", ") + value;
        series.colour           = static_cast<unsigned int>(plot.series.size());
        const std::size_t every = 1 + history.states().size() / 1000;
        for (std::size_t n = 0; n < history.states().size(); n += every)
          {
            series.x.push_back(second(history.states()[n].time));
            series.y.push_back(newton(history.states()[n].force));
          }
        plot.series.push_back(series);
      }
    page.section("Force against time");
    page.plots({plot});
  }



  std::vector<Fact>
  SweepPlots::smallest_and_largest_force() const
  {
    if (shown.empty())
      return {};
    const Quantity &force = shown.front();
    std::size_t     least = rows.size(), largest = rows.size();
    for (std::size_t point = 0; point < rows.size(); ++point)
      {
        const double f = value(force, point);
        if (std::isnan(f))
          continue;
        if (least == rows.size() || f < value(force, least))
          least = point;
        if (largest == rows.size() || f > value(force, largest))
          largest = point;
      }
    const auto where = [this](const std::size_t point) {
      std::string text;
      for (std::size_t i = 0; i < plan.entries().size(); ++i)
        text += (i == 0 ? "" : ", ") +
          assignment(plan.entries()[i], plan.values(point)[i], " ");
      return text;
    };
    const Figure &figure = impact_figures()[force.index];
    return {{"Smallest peak force",
             number(*rows[least]->figures[force.index], figure.unit),
             "at " + where(least)},
            {"Largest peak force",
             number(*rows[largest]->figures[force.index], figure.unit),
             "at " + where(largest)}};
  }



  std::vector<SweepPlots::Quantity>
  SweepPlots::quantities() const
  {
    std::vector<Quantity> result;
    for (const std::string &name : plotted)
      for (std::size_t i = 0; i < impact_figures().size(); ++i)
        {
          const Figure &figure = impact_figures()[i];
          if (figure.name != name)
            continue;
          std::vector<double> values;
          for (const auto &row : rows)
            if (row->failure.empty() && row->figures[i])
              values.push_back(*row->figures[i]);
          if (values.empty())
            continue;
          if (name == "number_of_contacts" &&
              *std::max_element(values.begin(), values.end()) <= 1.)
            continue;
          if (figure.unit.empty())
            result.push_back({i, figure.title, 1.});
          else
            {
              const PrefixedUnit unit(figure.unit, values);
              result.push_back(
                {i, with_unit(figure.title, unit.name()), unit(1.)});
            }
        }
    return result;
  }



  SweepPlots::Scale
  SweepPlots::scale(const SweptEntry &entry) const
  {
    Scale scale{with_unit(entry.path, entry.unit), true, entry.values, {}};
    for (const std::string &text : entry.values)
      if (!any_number().read(text, scale.values.emplace_back()))
        scale.is_numeric = false;
    if (!scale.is_numeric)
      for (std::size_t i = 0; i < scale.values.size(); ++i)
        scale.values[i] = static_cast<double>(i + 1);
    return scale;
  }



  double
  SweepPlots::value(const Quantity &quantity, const std::size_t point) const
  {
    const SweepRow &row = *rows[point];
    return row.failure.empty() && row.figures[quantity.index] ?
      quantity.factor * *row.figures[quantity.index] :
      std::nan("");
  }



  Range
  SweepPlots::range(const Quantity &quantity) const
  {
    Range range;
    for (std::size_t point = 0; point < rows.size(); ++point)
      {
        const double v = value(quantity, point);
        range.lowest   = std::fmin(range.lowest, v);
        range.highest  = std::fmax(range.highest, v);
      }
    return range;
  }



  void
  SweepPlots::add_panels(Page                     &page,
                         const std::vector<Panel> &panels,
                         const bool                small) const
  {
    const SweptEntry &entry_a = plan.entries()[0], &entry_b = plan.entries()[1];
    const Scale       a = scale(entry_a), b = scale(entry_b);
    const std::size_t n_a = a.values.size(), n_b = b.values.size();
    const auto point = [n_b](const Panel &panel, std::size_t i, std::size_t j) {
      return panel.first + (i * n_b + j) * panel.stride;
    };
    // curves for each value of the entry with words or with fewer values
    if (!a.is_numeric || !b.is_numeric || std::min(n_a, n_b) <= 3)
      {
        const bool a_is_family =
          b.is_numeric && (!a.is_numeric || (n_a < n_b && n_a <= most_curves));
        const Scale             &x      = a_is_family ? b : a;
        const SweptEntry        &family = a_is_family ? entry_a : entry_b;
        std::vector<std::string> names;
        for (const std::string &text : family.values)
          names.push_back(assignment(family, text, " "));
        std::vector<Plot> plots;
        for (const Panel &panel : panels)
          {
            std::vector<std::vector<std::size_t>> points(names.size());
            for (std::size_t s = 0; s < names.size(); ++s)
              for (std::size_t i = 0; i < x.values.size(); ++i)
                points[s].push_back(a_is_family ? point(panel, s, i) :
                                                  point(panel, i, s));
            plots.push_back(curves(*panel.quantity, x, names, points));
            if (panel.title.empty())
              continue;
            plots.back().title   = panel.title;
            plots.back().y.title = unit_of(panel.quantity->title);
            plots.back().y.range = range(*panel.quantity);
          }
        return page.plots(plots, small ? PlotSize::small : PlotSize::medium);
      }

    std::vector<ColourMap> maps;
    for (const Panel &panel : panels)
      {
        const std::string &title = panel.quantity->title;
        maps.push_back({panel.title.empty() ? without_unit(title) : panel.title,
                        title,
                        {a.title},
                        {b.title},
                        a.values,
                        b.values,
                        {},
                        range(*panel.quantity)});
        for (std::size_t j = 0; j < n_b; ++j)
          for (std::size_t i = 0; i < n_a; ++i)
            {
              const std::size_t p = point(panel, i, j);
              if (!rows[p]->warnings.empty())
                maps.back().marked.push_back(maps.back().values.size());
              maps.back().values.push_back(value(*panel.quantity, p));
            }
      }
    page.colour_maps(maps, small);
  }



  Plot
  SweepPlots::curves(const Quantity                              &quantity,
                     const Scale                                 &x,
                     const std::vector<std::string>              &names,
                     const std::vector<std::vector<std::size_t>> &points) const
  {
    Plot plot;
    plot.title   = without_unit(quantity.title);
    plot.x.title = x.title;
    plot.y.title = quantity.title;
    for (std::size_t s = 0; s < points.size(); ++s)
      {
        std::vector<std::pair<double, double>> sorted;
        for (std::size_t i = 0; i < points[s].size(); ++i)
          sorted.emplace_back(x.values[i], value(quantity, points[s][i]));
        if (x.is_numeric)
          std::sort(sorted.begin(),
                    sorted.end(),
                    [](const auto &a, const auto &b) {
                      return a.first < b.first;
                    });
        Series series;
        series.name   = names[s];
        series.colour = static_cast<unsigned int>(s);
        series.style =
          sorted.size() <= 40 ? Style::line_and_points : Style::line;
        // more points do not show
        const std::size_t every = 1 + sorted.size() / 2000;
        for (std::size_t i = 0; i < sorted.size(); i += every)
          {
            series.x.push_back(sorted[i].first);
            series.y.push_back(sorted[i].second);
          }
        plot.series.push_back(series);
      }
    mark_warnings(quantity, x, points, plot);
    if (!x.is_numeric)
      for (std::size_t i = 0; i < x.texts.size(); ++i)
        plot.caption +=
          (i == 0 ? "" : ", ") + std::to_string(i + 1) + ": " + x.texts[i];
    return plot;
  }



  void
  SweepPlots::mark_warnings(const Quantity &quantity,
                            const Scale    &x,
                            const std::vector<std::vector<std::size_t>> &points,
                            Plot &plot) const
  {
    Series marked{"with warnings", {}, {}, 7, Style::points};
    for (const std::vector<std::size_t> &curve : points)
      for (std::size_t i = 0; i < curve.size(); ++i)
        if (!rows[curve[i]]->warnings.empty())
          {
            marked.x.push_back(x.values[i]);
            marked.y.push_back(value(quantity, curve[i]));
          }
    if (!marked.x.empty())
      plot.series.push_back(marked);
  }
} // namespace PlateImpact
