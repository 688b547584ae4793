#include "plate_impact/comparison/comparison_plots.h"

#include "plate_impact/base/text.h"

#include <algorithm>
#include <limits>
#include <string>

namespace PlateImpact
{
  namespace
  {
    /// A history has as many steps as a scene asks for; a plot shows that many.
    constexpr std::size_t max_states_of_a_curve = 600;



    /// Numbers of the meshes of a curve.
    std::vector<double>
    column(const ComparisonCurve                             &curve,
           const std::function<double(const ComparedMesh &)> &value)
    {
      std::vector<double> values;
      for (const ComparedMesh &mesh : curve.meshes)
        values.push_back(value(mesh));
      return values;
    }



    /// Two parallel numbers of a plot: cost and error.
    struct Measure
    {
      std::string                                 title;
      std::function<double(const ComparedMesh &)> value;
    };

    const std::vector<Measure> costs = {
      {"seconds, cycles before included [s]",
       [](const ComparedMesh &mesh) { return mesh.cumulative_seconds; }},
      {"unknowns",
       [](const ComparedMesh &mesh) { return mesh.degrees_of_freedom; }},
      {"cells", [](const ComparedMesh &mesh) { return mesh.cells; }}};

    const std::vector<Measure> errors = {
      {"error of the peak force [%]",
       [](const ComparedMesh &mesh) { return 100. * mesh.peak_force_error; }},
      {"η [%]", [](const ComparedMesh &mesh) { return 100. * mesh.eta; }}};
  } // namespace



  ComparisonPlots::ComparisonPlots(const Scene              &scene,
                                   const StrategyComparison &comparison)
    : scene(scene)
    , comparison(comparison)
  {}



  Series
  ComparisonPlots::series(const ComparisonCurve &curve) const
  {
    const auto &strategies = scene.parameters.comparison.strategies;
    const auto  place =
      std::find(strategies.begin(), strategies.end(), curve.strategy);
    return {word_for(curve.strategy),
            {},
            {},
            static_cast<unsigned int>(place - strategies.begin()),
            Style::line_and_points};
  }



  std::vector<Plot>
  ComparisonPlots::plots_by_element(
    const Plot                                                   &frame,
    const std::function<void(const ComparisonCurve &, Series &)> &fill) const
  {
    std::vector<Plot> plots;
    for (const ElementType element : scene.parameters.comparison.elements)
      {
        Plot plot  = frame;
        plot.title = word_for(element);
        for (const ComparisonCurve &curve : comparison.curves())
          if (curve.element == element)
            {
              plot.series.push_back(series(curve));
              fill(curve, plot.series.back());
            }
        plots.push_back(plot);
      }
    return plots;
  }



  void
  ComparisonPlots::add_costs(Page &page) const
  {
    page.section("Error against cost");
    page.paragraph(
      "Every point is a mesh. Errors of the peak force below the dashed line, "
      "the uncertainty of the reference, say nothing about the mesh.");
    std::vector<Plot> plots;
    for (const Measure &error : errors)
      {
        Plot plot{error.title,
                  "",
                  {costs[0].title, true},
                  {error.title, true},
                  {},
                  {},
                  {{costs[1].title, true}, {costs[2].title, true}}};
        for (const ComparisonCurve &curve : comparison.curves())
          {
            plot.series.push_back(series(curve));
            Series &line = plot.series.back();
            line.marker  = word_for(curve.element);
            line.x       = column(curve, costs[0].value);
            line.y       = column(curve, error.value);
            line.more_x  = {column(curve, costs[1].value),
                            column(curve, costs[2].value)};
          }
        if (&error == &errors.front())
          add_uncertainty(plot);
        plots.push_back(plot);
      }
    page.plots(plots, PlotSize::large);
  }



  void
  ComparisonPlots::add_uncertainty(Plot &plot) const
  {
    const double uncertainty = 100. * comparison.reference().uncertainty;
    // from the smallest to the largest of all series
    const auto extent = [&plot](const auto &xs_of) {
      double first = std::numeric_limits<double>::infinity(), last = 0.;
      for (const Series &series : plot.series)
        for (const double x : xs_of(series))
          {
            first = std::min(first, x);
            last  = std::max(last, x);
          }
      return std::vector<double>{first, last};
    };
    const auto seconds = extent([](const Series &s) { return s.x; });
    if (!(uncertainty > 0. && seconds[0] < seconds[1]))
      return;
    Series line{"uncertainty of the reference",
                seconds,
                {uncertainty, uncertainty},
                static_cast<unsigned int>(
                  scene.parameters.comparison.strategies.size()),
                Style::dashed};
    for (std::size_t i = 0; i < plot.more_x.size(); ++i)
      line.more_x.push_back(
        extent([i](const Series &s) { return s.more_x[i]; }));
    plot.series.push_back(line);
  }



  void
  ComparisonPlots::add_effectivity(Page &page) const
  {
    if (!comparison.reference().field_error)
      return;
    page.section("Effectivity of the estimator");
    page.paragraph("η over the error in energy against the reference, on "
                   "meshes whose η is at least three times the reference's.");
    page.plots(
      plots_by_element(
        {"effectivity", "", {"cells", true}, {"effectivity", false}, {}, {}},
        [](const ComparisonCurve &curve, Series &series) {
          for (const ComparedMesh &mesh : curve.meshes)
            if (mesh.effectivity)
              {
                series.x.push_back(mesh.cells);
                series.y.push_back(*mesh.effectivity);
              }
        }),
      PlotSize::small);
  }



  void
  ComparisonPlots::add_histories(Page &page) const
  {
    page.section("Force histories");
    page.paragraph("On the last mesh of every curve.");
    const PrefixedUnit time("s", scene.parameters.time.end_time);
    const PrefixedUnit force("N", comparison.reference().peak_force);
    const auto fill = [&](const ContactHistory &history, Series &series) {
      const auto       &states = history.states();
      const std::size_t stride =
        1 + (states.size() - 1) / max_states_of_a_curve;
      for (std::size_t i = 0; i < states.size(); i += stride)
        {
          series.x.push_back(time(states[i].time));
          series.y.push_back(force(states[i].force));
        }
    };
    std::vector<Plot> plots =
      plots_by_element({"",
                        "",
                        {"time [" + time.name() + "]", false},
                        {"force [" + force.name() + "]", false},
                        {},
                        {}},
                       [&](const ComparisonCurve &curve, Series &series) {
                         series.style = Style::line;
                         if (curve.history)
                           fill(*curve.history, series);
                       });
    if (comparison.reference().history)
      for (Plot &plot : plots)
        {
          plot.series.push_back(
            {"reference",
             {},
             {},
             static_cast<unsigned int>(
               scene.parameters.comparison.strategies.size()),
             Style::dashed});
          fill(*comparison.reference().history, plot.series.back());
        }
    page.plots(plots, PlotSize::small);
  }
} // namespace PlateImpact
