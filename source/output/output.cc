#include "plate_impact/output/output.h"

#include <deal.II/base/timer.h>
#include <deal.II/grid/grid_tools.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/version.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  using namespace dealii;
  namespace fs = std::filesystem;

  namespace
  {
    void
    write_element_errors(std::ostream &out, const Cycle &cycle)
    {
      const AdaptivityParameters &adaptivity = cycle.parameters.adaptivity;
      const ErrorRatios          &error      = *cycle.result.error_ratios;
      const std::vector<double>   sizes =
        target_sizes(cycle.mesh(), error, adaptivity);
      out.precision(17);
      out << "cell,center_x,center_y,size,element_error,target_size\n";
      for (const auto &cell : cycle.mesh().active_cell_iterators())
        {
          const unsigned int c = cell->active_cell_index();
          out << c << ',' << cell->center()[0] << ',' << cell->center()[1]
              << ',' << cell_size(cell) << ',' << error.elements[c] << ','
              << CellSizing(cell, adaptivity).allowed(sizes[c]) << '\n';
        }
    }



    /// Of xi' in pictures of meshes.
    constexpr double lowest = 0.1, highest = 10.;

    /// Colour of xi' on a logarithmic scale: blue below the limit of 1, white
    /// at it, red above.
    std::string
    colour(const double xi)
    {
      const double s =
        std::log(std::clamp(xi, lowest, highest)) / std::log(highest);
      const Eigen::Vector3d white(247., 247., 247.), blue(33., 102., 172.),
        red(178., 24., 43.);
      const Eigen::Vector3d mixed =
        white + std::abs(s) * ((s < 0. ? blue : red) - white);
      return fmt::format("rgb({:.0f})",
                         fmt::join(mixed.data(), mixed.data() + 3, ","));
    }



    std::string
    svg_text(const double left, const double top, const std::string &text)
    {
      return fmt::format("<text x=\"{:.8g}\" y=\"{:.8g}\">{}</text>\n",
                         left,
                         top,
                         text);
    }



    void
    write_scale(std::ostream &out, const double left, const double top)
    {
      const double       height = 300.;
      const unsigned int n      = 40;
      out << svg_text(left, top - 12, "local error ratio xi&#8242;");
      for (unsigned int i = 0; i < n; ++i)
        out << fmt::format(
          "<rect x=\"{:.8g}\" y=\"{:.8g}\" width=\"18\" height=\"{:.8g}\" fill=\"{}\"/>\n",
          left,
          top + height * i / n,
          height / n + 0.5,
          colour(highest * std::pow(lowest / highest, (i + 0.5) / n)));
      for (const double tick : {10., 3., 1., 0.3, 0.1})
        out << svg_text(
          left + 24,
          top + 4 +
            height * std::log(highest / tick) / std::log(highest / lowest),
          fmt::format("{:g}{}", tick, tick == 1. ? " (limit)" : ""));
    }



    /// A mesh with its cells coloured by xi', where that is known, and a scale.
    void
    write_mesh_svg(std::ostream &out, const Cycle &cycle)
    {
      const CycleResult &result = cycle.result;
      const auto         box =
        GridTools::compute_bounding_box(cycle.mesh()).get_boundary_points();
      const Tensor<1, 2> extent    = box.second - box.first;
      const bool         has_scale = result.error_ratios.has_value();
      std::string        title =
        fmt::format("Cycle {}: {} cells", result.cycle, result.cells);
      if (result.error)
        title += ", eta = " + about_percentage(result.error->eta);
      title += '.';
      if (geometry_of(cycle.parameters.plate).n_parts() == 4.)
        title += " Impact at the lower left corner.";
      const double margin = 20., header = 34.,
                   scale  = 600. / std::max(extent[0], extent[1]);
      const double bottom = header + margin + extent[1] * scale;
      const double right  = 2 * margin + extent[0] * scale;
      out
        << fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.8g} {1:.8g}\" width=\"{0:.8g}\" height=\"{1:.8g}\" font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
             std::max(right + (has_scale ? 150. : 0.), 420.),
             std::max(bottom + margin,
                      has_scale ? header + 2 * margin + 330. : 0.))
        << svg_text(margin, header - 8, title)
        << "<g class=\"mesh\" stroke=\"#444\" stroke-width=\"0.6\">\n";
      for (const auto &cell : cycle.mesh().active_cell_iterators())
        {
          out << "<polygon points=\"";
          for (const unsigned int v : {0, 1, 3, 2})
            {
              const Tensor<1, 2> place = scale * (cell->vertex(v) - box.first);
              out << fmt::format("{}{:.2f},{:.2f}",
                                 v == 0 ? "" : " ",
                                 margin + place[0],
                                 bottom - place[1]);
            }
          out << "\" fill=\""
              << (has_scale ? colour(result.error_ratios
                                       ->elements[cell->active_cell_index()]) :
                              "none")
              << "\"/>\n";
        }
      out << "</g>\n";
      if (has_scale)
        write_scale(out, right, header + margin + 24.);
      out << "</svg>\n";
    }



    /// The largest of all plies by their names, and those of every ply.
    void
    add_stresses(const ComputedImpact &impact, Json &cycle)
    {
      const PlateParameters &plate    = impact.plate;
      const Eigen::MatrixXd &stresses = impact.result.error->max_stresses;
      if (!plate.is_laminate())
        {
          cycle["max_effective_stress"] = stresses(0, 0);
          return;
        }
      const auto &names = PlateSection(plate).stress_names();
      for (std::size_t k = 0; k < names.size(); ++k)
        {
          cycle["max_" + names[k].first] = stresses.col(k).maxCoeff();
          for (Eigen::Index ply = 0; ply < stresses.rows(); ++ply)
            {
              Json &of_ply           = cycle["plies"][ply];
              of_ply["ply"]          = ply + 1;
              of_ply["angle"]        = plate.layup.angles[ply];
              of_ply[names[k].first] = stresses(ply, k);
            }
        }
    }



    void
    add_quantities(const ComputedImpact &impact, Json &cycle)
    {
      const CycleResult &result   = impact.result;
      const double       end_time = impact.last.time;
      for (const ImpactQuantity &quantity : impact_quantities)
        add_known(cycle, quantity.name, quantity.value(impact));
      cycle["number_of_contacts"] = impact.history.n_contacts();
      if (!impact.impactor.is_cylinder())
        cycle["zener_peak_force"] = impact.expected.peak.force;
      if (result.damping > 0. && impact.peak.force > 0.)
        cycle["loss_factor_of_contact"] = result.loss_factor_of_contact();
      add_known(cycle, "time_error", result.time_error);
      if (result.peak_force_error)
        cycle["peak_force_error_estimate"] =
          result.peak_force_error->estimate();
      if (const auto &bar = result.peak_force_bar)
        cycle.update({{"peak_force_error_space", bar->space},
                      {"peak_force_error_time", bar->time}});
      if (const auto &verification = result.verification)
        cycle["verification"] = {
          {"cells", verification->n_cells},
          {"peak_force", verification->force},
          {"relative_change", verification->force / impact.peak.force - 1.}};
      if (result.sensitivity)
        cycle["sensitivity"] = result.sensitivity->factor;
      add_known(cycle, "no_contact_after", result.separation_time);
      cycle["plate_displacement_at_peak"] = impact.peak.plate_displacement;
      if (result.error)
        add_stresses(impact, cycle);
      cycle.update({{"returns_of_waves", result.returns_of_waves},
                    {"steps", result.steps},
                    {"end_time", end_time},
                    {"time_step", end_time / result.steps},
                    {"work",
                     {{"factorizations", result.work.factorizations},
                      {"linear_solves", result.work.linear_solves},
                      {"contact_steps", result.contact_steps},
                      {"estimator_samples",
                       result.error ? result.error->sample_times.size() : 0},
                      {"ritz_vectors", result.work.ritz_vectors}}}});
    }



    /// What summary.json says of a cycle (doc/results.md has every key).
    Json
    summary_of(const CycleResult &result, const Scene &scene)
    {
      Json cycle = {{"cycle", result.cycle},
                    {"cells", result.cells},
                    {"degrees_of_freedom", result.degrees_of_freedom},
                    {"min_cell_size", result.min_cell_size}};
      if (const auto &error = result.error)
        {
          cycle["discretization_error"] = error->eta;
          if (error->n_singular_cells > 0)
            cycle.update(
              {{"singular_cells", error->n_singular_cells},
               {"discretization_error_of_all_cells", error->eta_of_all_cells},
               {"discretization_error_of_regular_cells",
                error->eta_of_regular_cells}});
          cycle.update(
            {{"max_element_error", result.error_ratios->max_element()},
             {"cells_above_limit", result.cells_above_limit},
             {"cells_at_minimum_size", result.cells_at_minimum_size}});
        }
      if (result.history)
        add_quantities({scene.parameters, *scene.expected, result}, cycle);
      if (!result.natural_frequencies.empty())
        cycle["natural_frequencies"] = result.natural_frequencies;
      const Seconds &s            = result.seconds;
      cycle["seconds"]            = {{"mesh", s.mesh},
                                     {"assembly", s.assembly},
                                     {"factorization", s.factorization},
                                     {"stepping", s.stepping},
                                     {"estimation", s.estimation},
                                     {"output", s.output},
                                     {"total", s.total()}};
      cycle["cumulative_seconds"] = result.cumulative_seconds();
      return cycle;
    }
  } // namespace



  Output::Output(const Scene &scene)
    : directory(scene.parameters.output.directory)
    , scene(scene)
  {
    for (const char *list : {"histories", "errors", "meshes", "stresses"})
      study[list] = Json::array();
    directory.clear();
    directory.write_scene(scene.name, scene.text);
  }



  void
  Output::write_cycle(Cycle &cycle)
  {
    const Timer       timer;
    CycleResult      &result = cycle.result;
    const std::string suffix = "_cycle_" + std::to_string(result.cycle);
    if (result.history)
      {
        if (result.cycle > 1)
          {
            const fs::path earlier = directory /
              ("contact_history_cycle_" + std::to_string(result.cycle - 1) +
               ".csv");
            std::error_code error;
            fs::rename(directory / "contact_history.csv", earlier, error);
            if (error)
              throw ComputationError(earlier.string() +
                                     " cannot be written: " + error.message());
          }
        directory.write_file("contact_history.csv", [&](std::ostream &out) {
          result.history->write(out);
        });
      }
    if (result.error)
      directory.write_file("element_errors" + suffix + ".csv",
                           [&](std::ostream &out) {
                             write_element_errors(out, cycle);
                           });
    if (scene.parameters.output.write_meshes)
      directory.write_file("mesh" + suffix + ".svg", [&](std::ostream &out) {
        write_mesh_svg(out, cycle);
      });
    if (scene.parameters.output.write_report)
      add_to_report(cycle, study);
    result.seconds.output += timer.wall_time();
    cycles.push_back(summary_of(result, scene));
  }



  Json
  Output::write_summary(const std::string &outcome, const Verdict &verdict)
  {
    const auto part = [](const Verdict::Part &part) {
      return Json{{"trust", word_for(part.trust)}, {"reasons", part.reasons}};
    };
    Json summary = {{"scene", scene.name},
                    {"version", PLATE_IMPACT_VERSION},
                    {"outcome", outcome},
                    {"verdict",
                     {{"trust", word_for(verdict.trust())},
                      {"text", verdict.text},
                      {"contact", verdict.warnings.contact},
                      {"convergence", part(verdict.convergence)},
                      {"model", part(verdict.model)}}}};
    for (const ModelError &error : verdict.warnings.model_errors)
      {
        Json &errors = summary["verdict"]["model"]["errors"];
        errors.push_back({{"of", error.of}});
        add_known(errors.back(), "relative", error.relative);
      }
    if (!verdict.warnings.damage.empty())
      summary["verdict"]["damage"] = verdict.warnings.damage;
    if (scene.parameters.has_impactor())
      summary["local_response"] =
        word_for(scene.parameters.contact.local_response);
    for (const auto &[path, value] : scene.inputs)
      summary["inputs"][path] = value;
    summary["warnings"] = verdict.warnings.all();
    summary["cycles"]   = cycles;
    directory.write_file("summary.json", summary.dump(2) + '\n');
    return summary;
  }



  void
  Output::finish(const Outcome outcome, const Verdict &verdict, Cycle &last)
  {
    const Timer timer;
    if (!last.result.snapshots.empty())
      write_fields(directory, last);
    last.result.seconds.output += timer.wall_time();
    cycles.back()    = summary_of(last.result, scene);
    study["text"]    = scene.text;
    study["summary"] = write_summary(word_for(outcome), verdict);
    if (scene.parameters.output.write_report)
      directory.write_file("report.html",
                           report(scene, verdict, last, std::move(study)));
  }



  void
  Output::write_failure(const std::string &failure)
  {
    try
      {
        Verdict verdict;
        verdict.text        = "the computation has failed";
        verdict.convergence = {Trust::none, {failure}};
        write_summary("failed: " + failure, verdict);
      }
    catch (const ComputationError &)
      {
        // the disk that failed first fails again: the first failure is the news
      }
  }
} // namespace PlateImpact
