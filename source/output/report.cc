#include "plate_impact/output/report.h"

#include "plate_impact/base/text.h"
#include "plate_impact/base/version.h"
#include "plate_impact/output/cycle_plots.h"
#include "plate_impact/output/run_in_words.h"
#include "plate_impact/page/mesh_picture.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace PlateImpact
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /// More points than these do not show on a screen.
    constexpr std::size_t max_plotted_states = 1200;

    /// Cells of all meshes together that a page shows; a browser is slow with
    /// more.
    constexpr std::size_t max_pictured_cells = 15000;



    /// Recovered resultants of a state at the centres of the cells.
    std::vector<CellField>
    resultant_fields(const Snapshot &state, const Cycle &cycle)
    {
      const Eigen::MatrixXd resultants =
        cycle.recovered_resultants(state.unknowns,
                                   {dealii::Point<2>(0.5, 0.5)});
      const std::string      names[] = {"moment M_x [N]",
                                        "moment M_y [N]",
                                        "moment M_xy [N]",
                                        "shear force Q_x [N/m]",
                                        "shear force Q_y [N/m]"};
      std::vector<CellField> fields;
      for (unsigned int i = 0; i < 5; ++i)
        {
          const Eigen::VectorXd values = resultants.row(i);
          fields.push_back({names[i], false, {values.begin(), values.end()}});
        }
      const PlateSection            &section = cycle.discretization().section();
      const std::vector<std::string> words   = stresses_in_words(section);
      for (unsigned int k = 0; k < words.size(); ++k)
        {
          CellField stress{words[k] + " [Pa]", false, {}};
          for (Eigen::Index c = 0; c < resultants.cols(); ++c)
            stress.values.push_back(
              section
                .stresses(resultants(0, c), resultants(1, c), resultants(2, c))
                .col(k)
                .maxCoeff());
          fields.push_back(stress);
        }
      return fields;
    }
  } // namespace



  Report::Report(const Scene &scene)
    : scene(scene)
  {}



  Report::PlottedHistory
  Report::plotted(const CycleResult &result)
  {
    const std::vector<ContactState> &states = result.history->states();
    const std::size_t stride = 1 + (states.size() - 1) / max_plotted_states;
    const ContactState *const peak = &result.history->peak();

    PlottedHistory history;
    history.cycle = result.cycle;
    for (std::size_t i = 0; i < states.size(); ++i)
      {
        const ContactState &state = states[i];
        if (i % stride != 0 && i + 1 != states.size() && &state != peak)
          continue;
        history.time.push_back(state.time);
        history.force.push_back(state.force);
        history.plate_displacement.push_back(state.plate_displacement);
        history.impactor_displacement.push_back(state.impactor_displacement);
        history.indentation.push_back(state.indentation);
        history.plate_energy.push_back(state.plate_energy);
        history.contact_energy.push_back(state.contact_energy);
        history.impactor_energy.push_back(state.impactor_energy);
        history.total_energy.push_back(state.total_energy());
      }
    return history;
  }



  std::pair<double, double>
  Report::extent_of(const PlottedHistory &history, const Quantities &quantities)
  {
    double low = 0., high = 0.;
    for (const auto &[name, values] : quantities)
      for (const double value : history.*values)
        {
          low  = std::min(low, value);
          high = std::max(high, value);
        }
    // round, a fifth of a decade and a little room above
    const double step =
      high > low ? std::pow(10., std::floor(std::log10(high - low))) / 5. : 1.;
    return {std::floor(low / step) * step,
            std::ceil(1.02 * high / step) * step};
  }



  void
  Report::add_outcome(Page &page, const Json &summary) const
  {
    page.section("Outcome");
    const Json &verdict     = summary["verdict"],
               &convergence = verdict["convergence"], &model = verdict["model"];
    page.verdict(convergence["trust"], verdict["text"], convergence["reasons"]);
    if (!histories.empty())
      page.verdict(model["trust"],
                   model["trust"] == "good"   ? "Inside of the model" :
                     model["trust"] == "none" ? "Far outside of the model" :
                                                "Outside of the model",
                   model["reasons"]);
    page.facts(facts_of_run(scene.parameters, summary));
    if (histories.empty())
      return;
    page.heading("How far to trust the peak force");
    page.table(evidence_of_run(scene.parameters, summary));
  }



  void
  Report::add_histories(Page &page) const
  {
    if (histories.empty())
      return;
    const PlottedHistory &last = histories.back();
    const PrefixedUnit    time("s", last.time);
    const auto            plot = [&](const std::string &title,
                          const std::string &unit_name,
                          const Quantities  &quantities) {
      double largest = 0.;
      for (const auto &[name, values] : quantities)
        for (const double value : last.*values)
          largest = std::max(largest, std::abs(value));
      const PrefixedUnit unit(unit_name, largest);
      Plot               plot{title,
                "",
                {with_unit("time", time.name())},
                {with_unit(title, unit.name())},
                {},
                {}};
      for (const PlottedHistory &history : histories)
        for (std::size_t i = 0; i < quantities.size(); ++i)
          {
            const bool        is_last = &history == &last;
            const std::string cycle = "cycle " + std::to_string(history.cycle);
            const bool        is_one = quantities.size() == 1;
            plot.series.push_back(
              {is_one ? cycle :
                                   quantities[i].first + (is_last ? "" : ", " + cycle),
               time(history.time),
               unit(history.*(quantities[i].second)),
               unsigned(i),
               is_last ? Style::line : Style::faint});
          }
      const auto [low, high] = extent_of(last, quantities);
      plot.y.limits          = {unit(low), unit(high)};
      return plot;
    };
    page.section("Histories");
    using History    = PlottedHistory;
    Plot       force = plot("Force", "N", {{"", &History::force}});
    const auto peak  = std::max_element(last.force.begin(), last.force.end());
    const PrefixedUnit unit("N", *peak);
    force.series.push_back({"peak, " + unit.text(*peak) + " at " +
                              time.text(last.time[peak - last.force.begin()]),
                            {time(last.time[peak - last.force.begin()])},
                            {unit(*peak)},
                            1,
                            Style::points});
    page.plots({force});
    page.plots({plot("Displacement",
                     "m",
                     {{"plate", &History::plate_displacement},
                      {"impactor", &History::impactor_displacement},
                      {"indentation", &History::indentation}}),
                plot("Energy",
                     "J",
                     {{"impactor", &History::impactor_energy},
                      {"plate", &History::plate_energy},
                      {"contact", &History::contact_energy},
                      {"total", &History::total_energy}})});
    page.paragraph(
      "Pointer or arrow keys read values; a click on a name hides it. "
      "Cycles before the last are thin. contact_history.csv has every step.");
  }



  void
  Report::add_cycles(Page &page, const Json &cycles) const
  {
    page.section("Cycles");
    page.table(table_of_cycles(cycles));
    if (cycles.size() > 1)
      page.plots(
        {plot_over_cycles(cycles,
                          "discretization_error",
                          {"η [%]", true},
                          100.),
         plot_over_cycles(cycles, "peak_force", {"peak force [N]"}),
         plot_over_cycles(cycles, "degrees_of_freedom", {"unknowns", true}),
         errors_against_seconds(cycles)},
        PlotSize::small);
    if (!error_histories.empty())
      {
        const PrefixedUnit unit("s", error_histories.back().time);
        Plot plot{"Relative error in the energy norm over time, η(t)",
                  "‖e‖ over the norm of the solution at the samples of the "
                  "estimator; η is its mean with that norm as weight.",
                  {"time [" + unit.name() + "]"},
                  {"η(t) [%]", true},
                  {},
                  {}};
        for (const ErrorHistory &history : error_histories)
          plot.series.push_back(
            {"cycle " + std::to_string(history.cycle),
             unit(history.time),
             history.error,
             0,
             &history == &error_histories.back() ? Style::line : Style::faint});
        page.plots({plot});
      }
    page.plots({seconds_by_stage(cycles)});
  }



  void
  Report::add_meshes(Page &page) const
  {
    if (meshes.empty())
      return;
    page.section("Meshes");
    page.paragraph(meshed_part_in_words(scene.parameters.plate) +
                   " Resultants are those at the peak force, recovered, "
                   "at the centres of the cells.");
    // the last meshes matter most
    std::size_t              n_cells = 0;
    std::vector<MeshPicture> shown;
    for (auto mesh = meshes.rbegin(); mesh != meshes.rend(); ++mesh)
      {
        n_cells += mesh->n_cells;
        if (n_cells > max_pictured_cells)
          break;
        shown.insert(shown.begin(), *mesh);
      }
    if (shown.size() < meshes.size())
      page.paragraph("Meshes of too many cells for a page are left out; see "
                     "mesh_cycle_K.svg and Output/Field samples.");
    if (!shown.empty())
      page.meshes(shown);
  }



  void
  Report::add_film(Page &page, const Json &film) const
  {
    if (film.is_null())
      return;
    page.section("In time");
    page.paragraph("Deflection and local error ratio on the last mesh.");
    page.film(film);
  }



  void
  Report::add_scene(Page &page) const
  {
    page.section("Repeat it");
    page.paragraph("plate-impact " PLATE_IMPACT_VERSION
                   ". Save these values, which are in scene.prm too, and run");
    page.preformatted("plate-impact run scene.prm");
    page.preformatted(scene.text);
  }



  void
  Report::write(std::ostream &out, const Json &summary, const Json &film) const
  {
    Page page(scene.name, scene_in_words(scene.parameters));
    page.embed("summary", summary);
    add_outcome(page, summary);
    add_histories(page);
    add_film(page, film);
    add_meshes(page);
    add_cycles(page, summary["cycles"]);
    add_scene(page);
    page.write(out);
  }



  void
  Report::add_cycle(const Cycle &cycle)
  {
    const CycleResult &result = cycle.result;
    if (result.history)
      histories.push_back(plotted(result));
    if (result.error)
      {
        error_histories.push_back(
          {result.cycle, result.error->sample_times, {}});
        for (const double error : result.error->sample_errors)
          error_histories.back().error.push_back(100. * error);
      }
    std::string title = "Cycle " + std::to_string(result.cycle) + ": " +
      std::to_string(result.cells) + " cells";
    if (result.error)
      title += ", η = " + percentage(result.error->eta);
    MeshPicture mesh{title, result.cells, {}, {}};
    if (result.cells <= max_pictured_cells)
      {
        mesh.svg = mesh_picture(cycle.mesh(),
                                scene.parameters,
                                "Mesh of cycle " + std::to_string(result.cycle),
                                result.element_errors());
        if (result.error)
          mesh.fields.push_back(
            {"local error ratio ξ′", true, result.error_ratios->elements});
        if (result.peak_state)
          for (const CellField &field :
               resultant_fields(*result.peak_state, cycle))
            mesh.fields.push_back(field);
      }
    meshes.push_back(mesh);
  }
} // namespace PlateImpact
