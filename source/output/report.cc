#include "plate_impact/output/report.h"

#include "plate_impact/base/text.h"
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/output/deflection_film.h"
#include "plate_impact/output/run_in_words.h"
#include "plate_impact/output/section_fields.h"
#include "plate_impact/output/stress_lines.h"
#include "plate_impact/page/mesh_picture.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// More points than these do not show on a screen.
    constexpr std::size_t max_plotted_states = 1200;

    /// Cells of all meshes together that a page shows; a browser is slow with
    /// more.
    constexpr std::size_t max_pictured_cells = 15000;



    const std::vector<
      std::pair<std::string, std::function<double(const ContactState &)>>>
      columns_of_histories = {
        {"time", &ContactState::time},
        {"force", &ContactState::force},
        {"indentation", &ContactState::indentation},
        {"plate_displacement", &ContactState::plate_displacement},
        {"impactor_displacement", &ContactState::impactor_displacement},
        {"plate_energy", &ContactState::plate_energy},
        {"contact_energy", &ContactState::contact_energy},
        {"impactor_energy", &ContactState::impactor_energy},
        {"dissipated_energy", &ContactState::dissipated_energy},
        {"plate_dissipated_energy", &ContactState::plate_dissipated_energy},
        {"total_energy", &ContactState::total_energy}};



    /// Adds resultants of a state at the centres of the cells, recovered, and
    /// the stresses of the section under them.
    void
    add_resultants(const Snapshot &state, const Cycle &cycle, Json &fields)
    {
      for (const SectionField &field : section_fields(
             cycle.discretization().section(),
             cycle.recovered_resultants(state.unknowns,
                                        {dealii::Point<2>(0.5, 0.5)})))
        fields.push_back(
          {{"name", field.name},
           {"unit", field.unit},
           {"values",
            numbers_on_page({field.values.begin(), field.values.end()})}});
    }
  } // namespace



  Json
  history_on_page(const ContactHistory           &history,
                  const std::size_t               most_states,
                  const std::vector<std::string> &columns)
  {
    const std::vector<ContactState> &states = history.states();
    const std::size_t         stride = 1 + (states.size() - 1) / most_states;
    const ContactState *const peak   = &history.peak();
    Json                      result;
    for (const auto &[name, value] : columns_of_histories)
      {
        if (!columns.empty() &&
            std::find(columns.begin(), columns.end(), name) == columns.end())
          continue;
        std::vector<double> values;
        for (std::size_t i = 0; i < states.size(); ++i)
          if (i % stride == 0 || i + 1 == states.size() || &states[i] == peak)
            values.push_back(value(states[i]));
        result[name] = numbers_on_page(values);
      }
    return result;
  }



  void
  Report::add_cycle(const Cycle &cycle)
  {
    const CycleResult &result = cycle.result;
    if (result.history)
      histories.push_back(history_on_page(*result.history, max_plotted_states));
    if (result.error)
      errors.push_back(
        {{"time", numbers_on_page(result.error->sample_times)},
         {"error", numbers_on_page(result.error->sample_errors)}});
    const std::string title = "Cycle " + std::to_string(result.cycle) + ": " +
      std::to_string(result.cells) + " cells" +
      (result.error ? ", η = " + percentage(result.error->eta) : "");
    meshes.push_back(nullptr);
    if (result.cells > max_pictured_cells)
      return;
    meshes.back() = mesh_on_page(cycle.mesh(), title, result.element_errors());
    if (!result.peak_state)
      return;
    add_resultants(*result.peak_state, cycle, meshes.back()["fields"]);
    // of the first mesh and the last
    if (stresses.size() == 2)
      stresses.erase(1);
    stresses.push_back(stress_lines(cycle, *result.peak_state));
    stresses.back()["cycle"] = result.cycle;
  }



  void
  Report::write(std::ostream  &out,
                const Scene   &scene,
                const Verdict &verdict,
                const Json    &summary,
                const Cycle   &last)
  {
    const Parameters &parameters = scene.parameters;
    Json              study      = {{"study", "run"}, {"text", scene.text}};
    study["summary"]             = summary;
    study.update(plate_on_page(parameters));
    study["histories"] = std::move(histories);
    study["errors"]    = std::move(errors);
    if (parameters.has_impactor())
      {
        const ContactState &expected = scene.expected->peak;
        study["expected"]            = {{"force", expected.force},
                                        {"time", expected.time}};
        study["safety"]              = safety_of_bar;
        study["words"]               = {{"localResponse",
                                         local_response_in_words(parameters)},
                                        {"load", load_in_words(parameters)},
                                        {"model", model_in_words(verdict)}};
      }
    study["meshes"] = std::move(meshes);
    // the last meshes matter most
    std::size_t n_cells = 0;
    for (auto mesh = study["meshes"].rbegin(); mesh != study["meshes"].rend();
         ++mesh)
      {
        n_cells +=
          mesh->is_null() ? max_pictured_cells : (*mesh)["cells"].size() / 4;
        if (n_cells > max_pictured_cells)
          *mesh = nullptr;
      }
    study["stresses"] = std::move(stresses);
    study["film"]     = deflection_film(last);
    write_page(out,
               {scene.name,
                scene_in_words(parameters),
                parameters.has_impactor() ? "Peak force " + verdict.text +
                    ". " + model_in_words(verdict) + "." :
                                            "Nothing strikes the plate."},
               study);
  }
} // namespace PlateImpact
