#include "plate_impact/output/output.h"

#include <deal.II/base/timer.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/base/version.h"
#include "plate_impact/output/field_files.h"
#include "plate_impact/page/mesh_picture.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/plate_section.h"

#include <fmt/format.h>

namespace PlateImpact
{
  using namespace dealii;
  namespace fs = std::filesystem;

  namespace
  {
    void
    write_element_errors(std::ostream               &out,
                         const Triangulation<2>     &mesh,
                         const ErrorRatios          &error,
                         const AdaptivityParameters &adaptivity)
    {
      const std::vector<double> sizes = target_sizes(mesh, error, adaptivity);
      out.precision(17);
      out << "cell,center_x,center_y,size,element_error,target_size\n";
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const unsigned int c = cell->active_cell_index();
          out << c << ',' << cell->center()[0] << ',' << cell->center()[1]
              << ',' << cell_size(cell) << ',' << error.elements[c] << ','
              << allowed_size(sizes[c], cell, adaptivity) << '\n';
        }
    }



    std::string
    caption_of(const CycleResult &result, const bool is_quarter)
    {
      return fmt::format("Cycle {}: {} cells{}.{}",
                         result.cycle,
                         result.cells,
                         result.error ?
                           ", eta = " + about_percentage(result.error->eta) :
                           "",
                         is_quarter ? " Impact at the lower left corner." : "");
    }



    /// The largest of all plies by their names, and those of every ply.
    void
    add_stresses(const Eigen::MatrixXd &stresses,
                 const PlateParameters &plate,
                 Json                  &cycle)
    {
      if (stresses.size() == 0)
        return;
      if (!plate.is_laminate())
        {
          cycle["max_effective_stress"] = stresses(0, 0);
          return;
        }
      const auto &names = PlateSection(plate).stress_names();
      for (std::size_t k = 0; k < names.size(); ++k)
        cycle["max_" + names[k]] = stresses.col(k).maxCoeff();
      for (Eigen::Index ply = 0; ply < stresses.rows(); ++ply)
        {
          Json of_ply;
          of_ply["ply"]   = ply + 1;
          of_ply["angle"] = plate.layup.angles[ply];
          for (std::size_t k = 0; k < names.size(); ++k)
            of_ply[names[k]] = stresses(ply, k);
          cycle["plies"].push_back(of_ply);
        }
    }



    void
    add_quantities(const CycleResult &result,
                   const Parameters  &parameters,
                   const ZenerImpact &expected,
                   Json              &cycle)
    {
      const ComputedImpact impact{parameters, expected, result};
      for (const ImpactQuantity &quantity : impact_quantities)
        if (const auto value = quantity.value(impact))
          cycle[quantity.name] = *value;
      cycle["number_of_contacts"] = result.history->n_contacts();
      if (!parameters.impactor.is_cylinder())
        cycle["zener_peak_force"] = expected.peak.force;
    }



    /// What summary.json says of a cycle (doc/results.md has every key).
    /// @param expected  empty without an impactor
    Json
    summary_of(const CycleResult                &result,
               const Parameters                 &parameters,
               const std::optional<ZenerImpact> &expected)
    {
      Json cycle;
      cycle["cycle"]              = result.cycle;
      cycle["cells"]              = result.cells;
      cycle["degrees_of_freedom"] = result.degrees_of_freedom;
      cycle["min_cell_size"]      = result.min_cell_size;
      if (result.error)
        {
          cycle["discretization_error"] = result.error->eta;
          if (result.error->n_singular_cells > 0)
            {
              cycle["singular_cells"] = result.error->n_singular_cells;
              cycle["discretization_error_of_all_cells"] =
                result.error->eta_of_all_cells;
              cycle["discretization_error_of_regular_cells"] =
                result.error->eta_of_regular_cells;
            }
          cycle["max_element_error"]     = result.error_ratios->max_element();
          cycle["cells_above_limit"]     = result.cells_above_limit;
          cycle["cells_at_minimum_size"] = result.cells_at_minimum_size;
        }
      if (result.history)
        {
          const ContactHistory &history = *result.history;
          const ContactState   &peak    = history.peak();
          add_quantities(result, parameters, *expected, cycle);
          if (result.damping > 0. && peak.force > 0.)
            cycle["loss_factor_of_contact"] = result.loss_factor_of_contact();
          if (result.time_error)
            cycle["time_error"] = *result.time_error;
          if (result.peak_force_error)
            cycle["peak_force_error_estimate"] = result.peak_force_error->sum();
          if (const auto &bar = result.peak_force_bar)
            {
              cycle["peak_force_error_space"] = bar->space;
              cycle["peak_force_error_time"]  = bar->time;
            }
          if (const auto &verification = result.verification)
            cycle["verification"] = {
              {"cells", verification->cells},
              {"peak_force", verification->peak_force},
              {"relative_change", verification->peak_force / peak.force - 1.}};
          if (result.sensitivity)
            cycle["sensitivity"] = result.sensitivity->factor;
          if (result.separation_time)
            cycle["no_contact_after"] = *result.separation_time;
          cycle["plate_displacement_at_peak"] = peak.plate_displacement;
          if (result.error)
            add_stresses(result.error->max_stresses, parameters.plate, cycle);
          cycle["steps"]     = result.steps;
          cycle["end_time"]  = history.states().back().time;
          cycle["time_step"] = history.states().back().time / result.steps;
          cycle["work"]      = {{"factorizations", result.work.factorizations},
                                {"linear_solves", result.work.linear_solves},
                                {"contact_steps", result.contact_steps},
                                {"estimator_samples",
                            result.error ? result.error->sample_times.size() :
                                                0},
                                {"ritz_vectors", result.work.ritz_vectors}};
        }
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
    directory.clear();
    directory.write_scene(scene.name, scene.text);
  }



  void
  Output::write_cycle(Cycle &cycle)
  {
    const Timer             timer;
    CycleResult            &result = cycle.result;
    const Triangulation<2> &mesh   = cycle.mesh();
    const std::string       suffix = "_cycle_" + std::to_string(result.cycle);
    if (result.history)
      {
        if (result.cycle > 1)
          {
            const std::string earlier = "contact_history_cycle_" +
              std::to_string(result.cycle - 1) + ".csv";
            std::error_code error;
            fs::rename(directory / "contact_history.csv",
                       directory / earlier,
                       error);
            if (error)
              throw ComputationError((directory / earlier).string() +
                                     " cannot be written: " + error.message());
          }
        directory.write_file("contact_history.csv", [&](std::ostream &out) {
          result.history->write(out);
        });
      }
    if (result.error)
      directory.write_file("element_errors" + suffix + ".csv",
                           [&](std::ostream &out) {
                             write_element_errors(out,
                                                  mesh,
                                                  *result.error_ratios,
                                                  cycle.parameters.adaptivity);
                           });
    if (scene.parameters.output.write_meshes)
      directory.write_file("mesh" + suffix + ".svg", [&](std::ostream &out) {
        write_mesh_svg(
          out,
          mesh,
          caption_of(result,
                     geometry_of(scene.parameters.plate)->n_parts() == 4.),
          result.element_errors());
      });
    if (scene.parameters.output.write_report)
      report.add_cycle(cycle);
    result.seconds.output += timer.wall_time();
    cycles.push_back(summary_of(result, scene.parameters, scene.expected));
  }



  Json
  Output::write_summary(const std::string              &outcome,
                        const std::vector<std::string> &warnings,
                        const Verdict                  &verdict)
  {
    Json summary;
    summary["scene"]   = scene.name;
    summary["version"] = PLATE_IMPACT_VERSION;
    summary["outcome"] = outcome;
    const auto part    = [](const Verdict::Part &part) {
      return Json{{"trust", word_for(part.trust)}, {"reasons", part.reasons}};
    };
    summary["verdict"] = {{"trust", word_for(verdict.trust())},
                          {"text", verdict.text},
                          {"contact", verdict.warnings.contact},
                          {"convergence", part(verdict.convergence)},
                          {"model", part(verdict.model)}};
    for (const ModelError &error : verdict.warnings.model_errors)
      {
        Json &errors = summary["verdict"]["model"]["errors"];
        errors.push_back({{"of", error.of}});
        if (error.relative)
          errors.back()["relative"] = *error.relative;
      }
    if (!verdict.warnings.damage.empty())
      summary["verdict"]["damage"] = verdict.warnings.damage;
    if (scene.parameters.has_impactor())
      summary["local_response"] =
        word_for(scene.parameters.contact.local_response);
    for (const auto &[path, value] : scene.inputs)
      summary["inputs"][path] = value;
    summary["warnings"] = warnings;
    summary["cycles"]   = cycles;
    directory.write_file("summary.json", [&](std::ostream &out) {
      out << summary.dump(2) << '\n';
    });
    return summary;
  }



  void
  Output::finish(const Outcome                   outcome,
                 const std::vector<std::string> &warnings,
                 const Verdict                  &verdict,
                 Cycle                          &last)
  {
    const Timer timer;
    if (!last.result.snapshots.empty())
      write_fields(directory, last);
    last.result.seconds.output += timer.wall_time();
    cycles.back() = summary_of(last.result, scene.parameters, scene.expected);
    const Json summary = write_summary(word_for(outcome), warnings, verdict);
    if (scene.parameters.output.write_report)
      directory.write_file("report.html", [&](std::ostream &out) {
        report.write(out, scene, verdict, summary, last);
      });
  }



  void
  Output::write_failure(const std::string &failure)
  {
    try
      {
        Verdict verdict;
        verdict.text        = "the computation has failed";
        verdict.convergence = {Trust::none, {failure}};
        write_summary("failed: " + failure, {}, verdict);
      }
    catch (const ComputationError &)
      {
        // the disk that failed first fails again: the first failure is the news
      }
  }



  std::string
  Output::kept() const
  {
    return (directory / "").string() + " has " +
      counted(cycles.size(), "cycle");
  }
} // namespace PlateImpact
