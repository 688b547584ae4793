#include "plate_impact/output/report.h"

#include "plate_impact/base/text.h"
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/output/deflection_film.h"
#include "plate_impact/output/run_in_words.h"
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
        {"total_energy", &ContactState::total_energy}};



    /// Adds resultants of a state at the centres of the cells, recovered, and
    /// the stresses of the section under them.
    void
    add_resultants(const Snapshot &state, const Cycle &cycle, Json &fields)
    {
      const Eigen::MatrixXd resultants =
        cycle.recovered_resultants(state.unknowns,
                                   {dealii::Point<2>(0.5, 0.5)});
      const auto add = [&fields](const std::string     &name,
                                 const Eigen::VectorXd &values) {
        fields.push_back(
          {{"name", name},
           {"values", numbers_on_page({values.begin(), values.end()})}});
      };
      const char *const names[] = {"moment M_x [N]",
                                   "moment M_y [N]",
                                   "moment M_xy [N]",
                                   "shear force Q_x [N/m]",
                                   "shear force Q_y [N/m]"};
      for (unsigned int i = 0; i < 5; ++i)
        add(names[i], resultants.row(i));

      const PlateSection            &section = cycle.discretization().section();
      const std::vector<std::string> stresses =
        section.stress_names().size() == 1 ?
        std::vector<std::string>{"von Mises stress at the faces [Pa]"} :
        std::vector<std::string>{"largest stress along fibres [Pa]",
                                 "largest stress across fibres [Pa]",
                                 "largest shear stress of plies [Pa]"};
      Eigen::MatrixXd largest(resultants.cols(), stresses.size());
      for (Eigen::Index c = 0; c < resultants.cols(); ++c)
        largest.row(c) =
          section.stresses(resultants(0, c), resultants(1, c), resultants(2, c))
            .colwise()
            .maxCoeff();
      for (std::size_t k = 0; k < stresses.size(); ++k)
        add(stresses[k], largest.col(k));
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
    if (result.peak_state)
      add_resultants(*result.peak_state, cycle, meshes.back()["fields"]);
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
        const ExpectedPeak &expected = scene.expected->peak;
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
    study["film"] = deflection_film(last.result, last.discretization());
    write_page(out,
               {scene.name,
                scene_in_words(parameters),
                parameters.has_impactor() ? "Peak force " + verdict.text +
                    ". " + model_in_words(verdict) + "." :
                                            "Nothing strikes the plate."},
               study);
  }
} // namespace PlateImpact
