#include "plate_impact/output/report.h"

#include <deal.II/base/geometry_info.h>

#include "plate_impact/base/text.h"
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/estimator/recovered_field.h"
#include "plate_impact/output/plate_fields.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Cells of all meshes together that a page shows; a browser is slow with
    /// more.
    constexpr std::size_t max_pictured_cells = 15000;



    const HistoryColumns columns_of_histories = {
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



    /// How the contact force is spread, and what that means for its limit.
    std::string
    load_in_words(const Parameters &parameters)
    {
      const ContactParameters &contact = parameters.contact;
      const std::string        load    = word_for(contact.load_distribution);
      if (contact.load_is_singular())
        return load +
          (parameters.plate.shear_correction_factor > 10. ?
             "; the peak force converges, since the plate has no shear "
             "deformation" :
             ": the peak force does not converge under refinement");
      if (!contact.has_patch())
        return load;
      return load +
        (contact.load_has_length() ? " of half-width " : " of radius ") +
        number(contact.patch_radius, "m");
    }



    /// Of a line of stresses.
    constexpr unsigned int points_per_cell = 9;

    /// A straight line away from a point; distances along it are lengths.
    struct Ray
    {
      Point<2>     origin;
      Tensor<1, 2> direction;
    };

    /// Cells with straight edges that a ray meets, by the distances at which it
    /// enters them, with those at which it leaves them.
    std::map<double, std::pair<double, RecoveredField::Cell>>
    cells_along(const Ray &ray, const Triangulation<2> &mesh)
    {
      std::map<double, std::pair<double, RecoveredField::Cell>> cells;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          double enters = 0., leaves = std::numeric_limits<double>::max();
          // counter-clockwise: the cell is to the left of its edges
          const unsigned int corners[] = {0, 1, 3, 2, 0};
          for (unsigned int i = 0; i < 4; ++i)
            {
              const unsigned int a = corners[i], b = corners[i + 1];
              const Tensor<1, 2> out =
                cross_product_2d(cell->vertex(b) - cell->vertex(a));
              const double inside   = out * (cell->vertex(a) - ray.origin),
                           approach = out * ray.direction;
              if (approach == 0. && inside < 0.)
                leaves = -1.;
              else if (approach > 0.)
                leaves = std::min(leaves, inside / approach);
              else if (approach < 0.)
                enters = std::max(enters, inside / approach);
            }
          if (leaves - enters > 1e-4 * cell->diameter())
            cells.insert({enters, {leaves, cell}});
        }
      return cells;
    }

    Json
    stresses_along(const Ray      &ray,
                   const Cycle    &cycle,
                   RecoveredField &field,
                   const Snapshot &state)
    {
      const PlateDiscretization &plate     = cycle.discretization();
      const Eigen::MatrixXd      stiffness = plate.section().stiffness();
      std::vector<double>        distances;
      Json                       result;
      const auto add = [&](const char *kind, const RowMajorMatrix &resultants) {
        const auto fields =
          section_fields(plate.section(), resultants.transpose());
        for (std::size_t k = 0; k < fields.size(); ++k)
          {
            Json &line = result[kind][k];
            for (const Json &value : numbers_on_page(
                   {fields[k].values.begin(), fields[k].values.end()}))
              line.push_back(value);
            line.push_back(nullptr); // the gap
          }
      };
      for (const auto &[enters, rest] : cells_along(ray, plate.mesh()))
        {
          const auto &[leaves, cell] = rest;
          std::vector<Point<2>> unit_points;
          for (unsigned int i = 0; i < points_per_cell; ++i)
            {
              distances.push_back(
                enters + (leaves - enters) * i / (points_per_cell - 1));
              unit_points.push_back(GeometryInfo<2>::project_to_unit_cell(
                mapping_of(cell).transform_real_to_unit_cell(
                  cell,
                  ray.origin + distances.back() * ray.direction)));
            }
          distances.push_back(leaves); // the gap
          add("raw",
              resultants_at(plate,
                            cell->active_cell_index(),
                            stiffness,
                            plate.element.strains_at(cell, unit_points),
                            state.unknowns));
          add("recovered", field.evaluate(cell, unit_points));
        }
      result["distance"] = numbers_on_page(distances);
      return result;
    }



    /// What recovery makes of the stresses of the elements, along x, y and the
    /// diagonal, from the impact to the edge, for a page: `fields`, their names
    /// and units, and `lines`, each with a `title`, `distance` from the impact
    /// [m], and the values of the fields as the elements have them, `raw`, and
    /// `recovered`. Cells are set apart by a null, since raw values jump
    /// between them.
    Json
    stress_lines(const Cycle &cycle, const Snapshot &state)
    {
      const PlateDiscretization &plate  = cycle.discretization();
      Json                       fields = Json::array(), lines = Json::array();
      for (const SectionField &field :
           section_fields(plate.section(),
                          Eigen::MatrixXd::Zero(plate.section().n_resultants(),
                                                1)))
        fields.push_back({{"name", field.name}, {"unit", field.unit}});
      RecoveredField recovered(plate,
                               cycle.recovery(),
                               plate.section().stiffness(),
                               state.unknowns);
      // beside edges of cells, which would belong to two of them
      const double aside = 1e-6 * cycle.result.min_cell_size;
      const double half  = std::sqrt(0.5);
      const std::pair<const char *, Ray> rays[] = {
        {"Along x", {{0., aside}, Point<2>(1., 0.)}},
        {"Along y", {{aside, 0.}, Point<2>(0., 1.)}},
        {"Along the diagonal", {{aside, 0.}, Point<2>(half, half)}}};
      for (const auto &[title, ray] : rays)
        {
          lines.push_back({{"title", title}});
          lines.back().update(stresses_along(ray, cycle, recovered, state));
        }
      return {{"fields", fields}, {"lines", lines}};
    }
  } // namespace



  Json
  history_on_page(const ContactHistory &history, const HistoryColumns &columns)
  {
    const std::vector<ContactState> &states      = history.states();
    constexpr std::size_t            most_states = 1200; // more do not show
    const std::size_t         stride = 1 + (states.size() - 1) / most_states;
    const ContactState *const peak   = &history.peak();
    Json                      result;
    for (const auto &[name, value] : columns)
      {
        std::vector<double> values;
        for (std::size_t i = 0; i < states.size(); ++i)
          if (i % stride == 0 || i + 1 == states.size() || &states[i] == peak)
            values.push_back(value(states[i]));
        result[name] = numbers_on_page(values);
      }
    return result;
  }



  void
  add_to_report(const Cycle &cycle, Json &study)
  {
    const CycleResult &result = cycle.result;
    if (result.history)
      study["histories"].push_back(
        history_on_page(*result.history, columns_of_histories));
    if (result.error)
      study["errors"].push_back(
        {{"time", numbers_on_page(result.error->sample_times)},
         {"error", numbers_on_page(result.error->sample_errors)}});
    const std::string title = "Cycle " + std::to_string(result.cycle) + ": " +
      std::to_string(result.cells) + " cells" +
      (result.error ? ", η = " + percentage(result.error->eta) : "");
    Json &mesh = study["meshes"].emplace_back();
    if (result.cells > max_pictured_cells)
      return;
    mesh = mesh_on_page(cycle.mesh(), title, result.element_errors());
    if (!result.peak_state)
      return;
    for (const SectionField &field :
         section_fields(cycle.discretization().section(),
                        recovered_resultants(cycle.discretization(),
                                             cycle.recovery(),
                                             result.peak_state->unknowns,
                                             {dealii::Point<2>(0.5, 0.5)})
                          .front()))
      mesh["fields"].push_back(
        {{"name", field.name},
         {"unit", field.unit},
         {"values",
          numbers_on_page({field.values.begin(), field.values.end()})}});
    // of the first mesh and the last
    Json &stresses = study["stresses"];
    if (stresses.size() == 2)
      stresses.erase(1);
    stresses.push_back(stress_lines(cycle, *result.peak_state));
    stresses.back()["cycle"] = result.cycle;
  }



  void
  write_report(std::ostream  &out,
               const Scene   &scene,
               const Verdict &verdict,
               const Json    &summary,
               const Cycle   &last,
               Json           study)
  {
    const Parameters &parameters = scene.parameters;
    study["text"]                = scene.text;
    study["summary"]             = summary;
    study["film"]                = deflection_film(last);
    study.update(plate_on_page(parameters));
    if (parameters.has_impactor())
      {
        const ContactState &expected = scene.expected->peak;
        const double        force    = last.result.history->peak().force;
        const auto         &bar      = last.result.peak_force_bar;
        study["expected"]            = {{"force", expected.force},
                                        {"time", expected.time}};
        study["safety"]              = safety_of_bar;
        study["words"]               = {
                        {"localResponse", local_response_in_words(parameters)},
                        {"force", with_error(force, bar ? bar->total() * force : 0., "N")},
                        {"load", load_in_words(parameters)},
                        {"model", model_in_words(verdict)}};
      }
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
    write_page(out,
               {scene.name,
                scene_in_words(parameters),
                parameters.has_impactor() ? "Peak force " + verdict.text +
                    ". " + model_in_words(verdict) + "." :
                                            "Nothing strikes the plate."},
               study);
  }
} // namespace PlateImpact
