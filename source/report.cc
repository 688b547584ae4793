#include "plate_impact/report.h"

#include "plate_impact/contact_law.h"
#include "plate_impact/error_estimator.h"
#include "plate_impact/impactor.h"
#include "plate_impact/output.h"
#include "plate_impact/plate_model.h"
#include "plate_impact/plate_section.h"
#include "plate_impact/prefixed_unit.h"
#include "plate_impact/version.h"
#include "plate_impact/zener.h"

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



    /// A quantity of the table of cycles.
    struct Quantity
    {
      std::string name, key, unit; ///< unit of SI; "%" for fractions
    };

    const std::vector<Quantity> quantities = {
      {"Cells", "cells", ""},
      {"Unknowns", "degrees_of_freedom", ""},
      {"Smallest cell", "min_cell_size", "m"},
      {"η", "discretization_error", "%"},
      {"largest ξ′", "max_element_error", ""},
      {"Cells with ξ′ ≥ 1", "cells_above_limit", ""},
      {"Peak force", "peak_force", "N"},
      {"at", "time_of_peak_force", "s"},
      {"First contact ends", "first_contact_end", "s"},
      {"Contacts", "number_of_contacts", ""},
      {"Impulse", "impulse", "N s"},
      {"Impactor at the end", "final_impactor_velocity", "m/s"},
      {"Largest displacement", "max_plate_displacement", "m"},
      {"Largest stress", "max_effective_stress", "Pa"},
      {"Energy drift", "relative_energy_drift", ""}};



    /// What a quantity is over the cycles; NaN where a cycle does not have it.
    std::vector<double>
    over_cycles(const Json &cycles, const std::string &key)
    {
      std::vector<double> values;
      for (const Json &cycle : cycles)
        values.push_back(cycle.contains(key) ? cycle[key].get<double>() :
                                               std::nan(""));
      return values;
    }



    /// Quantities below each other: few cycles beside each other fit any
    /// screen.
    Table
    table_of_cycles(const Json &cycles)
    {
      Table table;
      table.columns.push_back("Cycle");
      for (const Json &cycle : cycles)
        table.columns.push_back(std::to_string(cycle["cycle"].get<int>()));
      for (const Quantity &quantity : quantities)
        {
          if (!cycles.back().contains(quantity.key))
            continue;
          std::vector<double> values = over_cycles(cycles, quantity.key);
          std::string         unit   = quantity.unit;
          if (unit == "%")
            for (double &value : values)
              value *= 100.;
          else if (!unit.empty())
            {
              const PrefixedUnit prefixed(unit, values);
              unit   = prefixed.name();
              values = prefixed(values);
            }
          table.rows.push_back(
            {quantity.name + (unit.empty() ? "" : " [" + unit + "]")});
          for (const double value : values)
            table.rows.back().push_back(six_digits(value));
        }
      return table;
    }



    /// The scene in a sentence.
    std::string
    description(const Parameters &parameters)
    {
      const PlateParameters &plate = parameters.plate;
      const PrefixedUnit     side("m",
                              std::max(plate.side_lengths[0],
                                       plate.side_lengths[1])),
        thickness("m", plate.thickness);
      std::string support = plate.support.front();
      if (plate.support.size() > 1 && plate.support[1] != support)
        support += " (x edges) and " + plate.support[1] + " (y edges)";
      const std::string target = "plate of " +
        six_digits(side(plate.side_lengths[0])) + " × " +
        side.text(plate.side_lengths[1]) + ", " +
        thickness.text(plate.thickness) + " thick, " + support;
      if (!parameters.has_impactor())
        return "A " + target + ". Nothing strikes it.";

      const ImpactorParameters &impactor = parameters.impactor;
      const auto text = [](const double value, const char *unit) {
        return PrefixedUnit(unit, value).text(value);
      };
      // masses in grams below one kilogram
      return "A " + impactor.shape + " of radius " +
        text(impactor.radius, "m") + " and mass " +
        text(1e3 * impactor.mass, "g") + " strikes the middle of a " + target +
        ", at " + text(impactor.velocity, "m/s") + ".";
    }



    std::string
    percentage(const double fraction)
    {
      return six_digits(100. * fraction) + " %";
    }



    /// Peak force and contact time of an infinite thin plate, beside ours.
    Fact
    zener_fact(const Parameters &parameters, const double peak_force)
    {
      const ExpectedPeak expected =
        zener_peak(*make_contact_law(parameters),
                   make_impactor(parameters.impactor),
                   PlateSection(parameters.plate));
      const double deviation = peak_force / expected.force - 1.;
      char         text[32];
      std::snprintf(text, sizeof(text), "%+.2f %%", 100. * deviation);
      return {"Zener's infinite thin plate",
              PrefixedUnit("N", expected.force).text(expected.force),
              "at " + PrefixedUnit("s", expected.time).text(expected.time) +
                (parameters.impactor.shape == "cylinder" ?
                   ", struck at a point: a lower bound for a cylinder; ours: " :
                   "; ours: ") +
                text};
    }



    /// A quantity over the cycles.
    Plot
    over_cycles_plot(const Json        &cycles,
                     const std::string &key,
                     const Axis        &y,
                     const double       factor = 1.)
    {
      std::vector<double> values = over_cycles(cycles, key);
      for (double &value : values)
        value *= factor;
      const std::string title = y.title.substr(0, y.title.find(" ["));
      return {title,
              "",
              {"cycle"},
              y,
              {{title,
                over_cycles(cycles, "cycle"),
                values,
                0,
                Style::line_and_points}},
              {}};
    }



    /// Recovered resultants of a state at the centres of the cells.
    std::vector<CellField>
    resultant_fields(const Snapshot       &state,
                     const PlateModel     &model,
                     const ErrorEstimator &estimator)
    {
      const Eigen::MatrixXd resultants =
        estimator.recovered_resultants(state.unknowns,
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
      CellField stress{"von Mises stress at the faces [Pa]", false, {}};
      for (Eigen::Index c = 0; c < resultants.cols(); ++c)
        stress.values.push_back(
          model.section().surface_von_mises_stress(resultants(0, c),
                                                   resultants(1, c),
                                                   resultants(2, c)));
      fields.push_back(stress);
      return fields;
    }



    Plot
    seconds_by_stage(const Json &cycles)
    {
      Plot plot{"Time by stage",
                "",
                {"wall time [s]", false},
                {"cycle", false},
                {},
                {}};
      for (const Json &cycle : cycles)
        plot.categories.push_back(std::to_string(cycle["cycle"].get<int>()));
      for (const auto &[stage, seconds] : cycles.back()["seconds"].items())
        {
          if (stage == "total")
            continue;
          std::vector<double> values;
          for (const Json &cycle : cycles)
            values.push_back(cycle["seconds"][stage].get<double>());
          plot.series.push_back(
            {stage, {}, values, unsigned(plot.series.size())});
        }
      return plot;
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



  void
  Report::add_outcome(Page &page, const Json &summary) const
  {
    const Json &last = summary["cycles"].back();
    page.section("Outcome");
    for (const std::string warning : summary["warnings"])
      page.notice("Warning: " + warning);
    std::vector<Fact> facts;
    const auto        number = [&last](const char *key) {
      return last[key].get<double>();
    };
    const auto with_unit = [](const double value, const char *unit) {
      return PrefixedUnit(unit, value).text(value);
    };
    if (last.contains("peak_force"))
      {
        facts.push_back({"Peak force",
                         six_digits(number("peak_force")) + " N",
                         "at " + with_unit(number("time_of_peak_force"), "s")});
        facts.push_back(zener_fact(scene.parameters, number("peak_force")));
        if (last.contains("first_contact_end"))
          facts.push_back(
            {"First contact ends",
             with_unit(number("first_contact_end"), "s"),
             "contacts: " + six_digits(number("number_of_contacts"))});
        facts.push_back({"Impactor at the end",
                         with_unit(number("final_impactor_velocity"), "m/s"),
                         "positive towards the plate; impulse " +
                           with_unit(number("impulse"), "N s")});
        facts.push_back(
          {"Largest displacement under the load",
           with_unit(number("max_plate_displacement"), "m"),
           "at the peak force " +
             with_unit(number("plate_displacement_at_peak"), "m")});
      }
    if (last.contains("discretization_error"))
      facts.push_back(
        {"Discretization error η",
         percentage(number("discretization_error")),
         "target " + percentage(scene.parameters.adaptivity.target_error) +
           "; largest ξ′ " + six_digits(number("max_element_error"))});
    facts.push_back(
      {"Outcome",
       summary["outcome"].get<std::string>(),
       "cycles: " + std::to_string(summary["cycles"].size()) +
         ", cells: " + six_digits(number("cells")) +
         ", unknowns: " + six_digits(number("degrees_of_freedom"))});
    page.facts(facts);
  }



  void
  Report::add_evidence(Page &page, const Json &summary) const
  {
    const Json       &cycles     = summary["cycles"];
    const Json       &last       = cycles.back();
    const Parameters &parameters = scene.parameters;
    if (!last.contains("peak_force"))
      return;
    const auto with_unit = [](const double value, const char *unit) {
      return PrefixedUnit(unit, value).text(value);
    };
    Table table{{"What the peak force depends on", "Evidence"}, {}, true};
    if (last.contains("discretization_error"))
      {
        std::string text = "η = " + percentage(last["discretization_error"]) +
          " of the energy norm, target " +
          percentage(parameters.adaptivity.target_error) +
          "; the peak force is usually far more accurate.";
        if (last.contains("singular_cells"))
          text += " Without " + six_digits(last["singular_cells"]) +
            " cells at the point load; with them " +
            percentage(last["discretization_error_of_all_cells"]) + ".";
        table.rows.push_back({"Mesh: estimated error", text});
      }
    if (cycles.size() > 1)
      {
        const double before = cycles[cycles.size() - 2]["peak_force"];
        const double change = last["peak_force"].get<double>() / before - 1.;
        table.rows.push_back(
          {"Mesh: change in the last cycle",
           percentage(change) + " (from " + six_digits(before) + " N)"});
      }
    table.rows.push_back({"Time step",
                          with_unit(parameters.time.time_step, "s") + ", " +
                            six_digits(last["steps"]) +
                            " steps; energy drift " +
                            six_digits(last["relative_energy_drift"]) +
                            (last.contains("first_contact_end") ? "; " +
                                 std::to_string(std::lround(
                                   last["first_contact_end"].get<double>() /
                                   parameters.time.time_step)) +
                                 " of the steps in the first contact" :
                                                                  "")});
    const std::string &load = parameters.contact.load_distribution;
    const double       cell = last["min_cell_size"];
    table.rows.push_back(
      {"Load",
       load == "point" || load == "line" ?
         load +
           ": the peak force has no limit under refinement; smallest "
           "cell " +
           with_unit(cell, "m") :
         load + (load == "strip" ? " of half-width " : " of radius ") +
           with_unit(parameters.contact.patch_radius, "m") +
           "; smallest cell " + with_unit(cell, "m")});
    page.heading("How far to trust the peak force");
    page.table(table);
  }



  void
  Report::add_histories(Page &page) const
  {
    if (histories.empty())
      return;
    const PlottedHistory &last = histories.back();
    const PrefixedUnit    time("s", last.time);
    const auto            plot =
      [&](const std::string &title,
          const std::string &unit_name,
          const std::vector<
            std::pair<std::string, std::vector<double> PlottedHistory::*>>
            &quantities) {
        double largest = 0.;
        for (const auto &[name, values] : quantities)
          for (const double value : last.*values)
            largest = std::max(largest, std::abs(value));
        const PrefixedUnit unit(unit_name, largest);
        Plot               plot{title,
                  "",
                  {"time [" + time.name() + "]"},
                  {title + " [" + unit.name() + "]"},
                  {},
                  {}};
        for (const PlottedHistory &history : histories)
          for (std::size_t i = 0; i < quantities.size(); ++i)
            {
              const bool        is_last = &history == &last;
              const std::string cycle =
                "cycle " + std::to_string(history.cycle);
              const bool is_one = quantities.size() == 1;
              plot.series.push_back(
                {is_one ? cycle :
                          quantities[i].first + (is_last ? "" : ", " + cycle),
                 time(history.time),
                 unit(history.*(quantities[i].second)),
                 is_one ? unsigned(&last - &history) : unsigned(i),
                 is_last || is_one ? Style::line : Style::faint});
            }
        return plot;
      };
    page.section("Histories");
    using History = PlottedHistory;
    page.plots({plot("Force", "N", {{"", &History::force}})});
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
        {over_cycles_plot(cycles,
                          "discretization_error",
                          {"η [%]", true},
                          100.),
         over_cycles_plot(cycles, "peak_force", {"peak force [N]"}),
         over_cycles_plot(cycles, "degrees_of_freedom", {"unknowns", true})},
        true);
    if (!error_histories.empty())
      {
        const PrefixedUnit unit("s", error_histories.back().time);
        Plot               plot{"Relative error in time, η(t)",
                  "‖e‖ over the norm of the solution at the samples of the "
                                "estimator; η is its mean with that norm as weight.",
                  {"time [" + unit.name() + "]"},
                  {"η(t) [%]", true},
                  {},
                  {}};
        for (const ErrorHistory &history : error_histories)
          plot.series.push_back({"cycle " + std::to_string(history.cycle),
                                 unit(history.time),
                                 history.error,
                                 unsigned(&error_histories.back() - &history)});
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
    page.paragraph("A quarter of the plate; the impact is at the lower left "
                   "corner. Resultants are those at the peak force, recovered, "
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
    page.paragraph("Deflection and element errors on the last mesh.");
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
    Page page(scene.name, description(scene.parameters));
    page.embed("summary", summary);
    add_outcome(page, summary);
    add_evidence(page, summary);
    add_histories(page);
    add_film(page, film);
    add_meshes(page);
    add_cycles(page, summary["cycles"]);
    add_scene(page);
    page.write(out);
  }



  void
  Report::add_cycle(const CycleResult    &result,
                    const PlateModel     &model,
                    const ErrorEstimator *estimator)
  {
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
        mesh.svg = mesh_picture(model.mesh(), result);
        if (result.error)
          mesh.fields.push_back(
            {"element error ξ′", true, result.error->element_errors});
        if (estimator != nullptr && result.peak_state)
          for (const CellField &field :
               resultant_fields(*result.peak_state, model, *estimator))
            mesh.fields.push_back(field);
      }
    meshes.push_back(mesh);
  }
} // namespace PlateImpact
