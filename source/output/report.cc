#include "plate_impact/output/report.h"

#include <deal.II/base/geometry_info.h>

#include "plate_impact/base/text.h"
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/plate_section.h"

#include <cmath>
#include <functional>
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



    /// A straight line away from a point; distances along it are lengths.
    struct Ray
    {
      const char  *title;
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

    /// Along a ray: `distance` from the impact [m], and the fields of the
    /// section as the elements have them, `raw`, and `recovered`, with the
    /// `title`. Cells are set apart by a null, since raw values jump between
    /// them.
    Json
    stresses_along(const Ray      &ray,
                   const Cycle    &cycle,
                   RecoveredField &field,
                   const Snapshot &state)
    {
      constexpr unsigned int     points_per_cell = 9;
      const PlateDiscretization &plate           = cycle.discretization();
      const PlateSection        &section         = plate.section;
      const auto                 cells = cells_along(ray, plate.mesh());
      std::vector<double>        distances;
      RowMajorMatrix             raw =
        RowMajorMatrix::Constant((points_per_cell + 1) * cells.size(),
                                 section.n_resultants(),
                                 std::numeric_limits<double>::quiet_NaN());
      RowMajorMatrix recovered = raw;
      for (const auto &[enters, rest] : cells)
        {
          const auto &[leaves, cell] = rest;
          const std::size_t     row  = distances.size();
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
          raw.middleRows(row, points_per_cell) =
            resultants_at(plate,
                          cell->active_cell_index(),
                          section.stiffness(),
                          plate.element.strains_at(cell, unit_points),
                          state.unknowns);
          recovered.middleRows(row, points_per_cell) =
            field.evaluate(cell, unit_points);
        }
      Json result = {{"distance", numbers_on_page(distances)}};
      for (const auto &[name, resultants] :
           {std::make_pair("raw", raw), std::make_pair("recovered", recovered)})
        for (const SectionField &line :
             section_fields(section, resultants.transpose()))
          result[name].push_back(numbers_on_page(line.values));
      result["title"] = ray.title;
      return result;
    }



    /// What recovery makes of the stresses of the elements, along x, y and the
    /// diagonal, from the impact to the edge.
    Json
    stress_lines(const Cycle &cycle, const Snapshot &state)
    {
      const PlateDiscretization &plate = cycle.discretization();
      RecoveredField             recovered(plate,
                               cycle.recovery(),
                               plate.section.stiffness(),
                               state.unknowns);
      // beside edges of cells, which would belong to two of them
      const double aside  = 1e-6 * cycle.result.min_cell_size;
      const double half   = std::sqrt(0.5);
      const Ray    rays[] = {{"Along x", {0., aside}, Point<2>(1., 0.)},
                             {"Along y", {aside, 0.}, Point<2>(0., 1.)},
                             {"Along the diagonal",
                              {aside, 0.},
                              Point<2>(half, half)}};
      Json         lines;
      for (const Ray &ray : rays)
        lines.push_back(stresses_along(ray, cycle, recovered, state));
      return lines;
    }
  } // namespace



  Json
  history_on_page(const ContactHistory &history, const bool has_all)
  {
    const std::pair<const char *, std::function<double(const ContactState &)>>
      columns[] = {
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
    const auto       &states      = history.states;
    const std::size_t most_states = 1200; // more do not show
    const std::size_t stride      = 1 + (states.size() - 1) / most_states;
    const auto *const peak        = &history.peak();
    Json              result;
    for (std::size_t k = 0; k < (has_all ? std::size(columns) : 2); ++k)
      {
        std::vector<double> values;
        for (std::size_t i = 0; i < states.size(); ++i)
          if (i % stride == 0 || i + 1 == states.size() || &states[i] == peak)
            values.push_back(columns[k].second(states[i]));
        result[columns[k].first] = numbers_on_page(values);
      }
    return result;
  }



  void
  add_to_report(const Cycle &cycle, Json &study)
  {
    const CycleResult &result = cycle.result;
    if (result.history)
      study["histories"].push_back(
        history_on_page(*result.history, /*has_all=*/true));
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
    // of the first mesh and the last
    Json &stresses = study["stresses"];
    if (stresses.size() == 2)
      stresses.erase(1);
    stresses.push_back({{"cycle", result.cycle},
                        {"lines", stress_lines(cycle, *result.peak_state)}});
    for (const SectionField &field :
         section_fields(cycle.discretization().section,
                        recovered_resultants(cycle.discretization(),
                                             cycle.recovery(),
                                             result.peak_state->unknowns,
                                             {Point<2>(0.5, 0.5)})
                          .front()))
      {
        Json named = {{"name", field.name}, {"unit", field.unit}};
        stresses.back()["fields"].push_back(named);
        named["values"] = numbers_on_page(field.values);
        mesh["fields"].push_back(named);
      }
  }



  std::string
  report(const Scene   &scene,
         const Verdict &verdict,
         const Cycle   &last,
         Json           study)
  {
    const Parameters &parameters = scene.parameters;
    study["film"]                = deflection_film(last);
    study.update(plate_on_page(parameters));
    if (parameters.has_impactor())
      {
        const double force              = last.result.history->peak().force;
        const auto  &bar                = last.result.peak_force_bar;
        const bool   is_on_softer_plate = bar && bar->is_on_softer_plate;
        study["expected"] = {{"force", scene.expected->peak.force},
                             {"time", scene.expected->peak.time}};
        study["words"]    = {
             {"localResponse", local_response_in_words(parameters)},
             {"estimate",
           !last.result.peak_force_error ?
                "by the mesh with every cell halved" :
                is_on_softer_plate ?
                "by the late peak on a softer plate, " +
               number(force * (1. - last.result.peak_force_error->estimate())) +
               " N, and its force around it" :
                "by the dual problem, with a factor of safety of " +
               number(last.result.peak_force_error->safety)},
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
    return page({scene.name,
                 scene_in_words(parameters),
                 parameters.has_impactor() ? "Peak force " + verdict.text +
                     ". " + model_in_words(verdict) + "." :
                                             "Nothing strikes the plate."},
                study);
  }
} // namespace PlateImpact
