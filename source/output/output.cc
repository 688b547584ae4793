#include "plate_impact/output/output.h"

#include "plate_impact/adaptation/cell_sizes.h"
#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/stage_clock.h"
#include "plate_impact/base/text.h"
#include "plate_impact/base/version.h"
#include "plate_impact/output/field_files.h"
#include "plate_impact/output/summary.h"
#include "plate_impact/page/mesh_picture.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

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
    StageClock              clock;
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
    clock.charge(result.seconds.output);
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
    summary["inputs"]   = inputs_of(scene.text);
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
    StageClock clock;
    if (!last.result.snapshots.empty())
      write_fields(directory, last);
    clock.charge(last.result.seconds.output);
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
