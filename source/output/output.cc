#include "plate_impact/output/output.h"

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/numerics/data_out.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/stage_clock.h"
#include "plate_impact/base/text.h"
#include "plate_impact/base/version.h"
#include "plate_impact/output/deflection_film.h"
#include "plate_impact/output/mirrored_fields.h"
#include "plate_impact/output/summary.h"
#include "plate_impact/page/mesh_picture.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

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
              << allowed_size(sizes[c], adaptivity) << '\n';
        }
    }



    /// A VTU file holds floats.
    void
    require_finite(const Vector<double> &fields, const double time)
    {
      // false for what is not a number, too
      const auto fits = [](const double value) {
        return std::abs(value) < std::numeric_limits<float>::max();
      };
      if (std::all_of(fields.begin(), fields.end(), fits))
        return;
      throw ComputationError("the fields at t = " + number(time, "s") +
                             " hold values beyond the numbers of a file");
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
    : scene(scene)
    , directory(scene.parameters.output.directory)
    , report(scene)
  {
    directory.clear();
    directory.write_scene(scene.name, scene.text);
  }



  void
  Output::write_file(const std::string                         &name,
                     const std::function<void(std::ostream &)> &write)
  {
    directory.write_file(name, write);
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
                                                  scene.parameters.adaptivity);
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
    cycles.push_back(summary_of(result, scene.parameters));
  }



  void
  Output::write_fields(const Cycle &cycle)
  {
    const CycleResult         &result       = cycle.result;
    const PlateDiscretization &plate        = cycle.discretization();
    std::vector<std::string>   field_names  = {"deflection",
                                               "rotation_x",
                                               "rotation_y",
                                               "moment_x",
                                               "moment_y",
                                               "moment_xy",
                                               "shear_force_x",
                                               "shear_force_y"};
    const auto                &stress_names = plate.section().stress_names();
    field_names.insert(field_names.end(),
                       stress_names.begin(),
                       stress_names.end());
    // values of every cell at its own nine nodes: what is recovered may differ
    // from cell to cell at hanging nodes
    const FE_DGQ<2>   nodal(2);
    const FESystem<2> fields_element(nodal, field_names.size());
    DoFHandler<2>     dof_handler(plate.mesh());
    dof_handler.distribute_dofs(fields_element);
    const std::vector<unsigned int> hierarchic =
      FETools::lexicographic_to_hierarchic_numbering<2>(2);
    const FESystem<2> &plate_element = plate.element().finite_element();

    std::vector<std::pair<double, std::string>> record;
    Vector<double>                              fields(dof_handler.n_dofs());
    Vector<float> element_errors(result.error_ratios->elements.begin(),
                                 result.error_ratios->elements.end());
    std::vector<types::global_dof_index> dofs(fields_element.n_dofs_per_cell());
    Eigen::MatrixXd                      values;
    for (const Snapshot &snapshot : result.snapshots)
      {
        const Eigen::MatrixXd resultants =
          cycle.recovered_resultants(snapshot.unknowns,
                                     nodal.get_unit_support_points());
        for (const auto &cell : dof_handler.active_cell_iterators())
          {
            const unsigned int c = cell->active_cell_index();
            plate.cell_values(c, snapshot.unknowns, values);
            cell->get_dof_indices(dofs);
            for (unsigned int node = 0; node < nodal.n_dofs_per_cell(); ++node)
              {
                const auto set = [&](const unsigned int field,
                                     const double       value) {
                  fields[dofs[fields_element.component_to_system_index(field,
                                                                       node)]] =
                    value;
                };
                for (unsigned int k = 0; k < n_components; ++k)
                  set(k,
                      values(plate_element
                               .component_to_system_index(k, hierarchic[node]),
                             0));
                const Resultants r = resultants.col(c).segment<5>(5 * node);
                for (unsigned int k = 0; k < 5; ++k)
                  set(n_components + k, r[k]);
                const Eigen::RowVectorXd stresses =
                  plate.section()
                    .stresses(r[0], r[1], r[2])
                    .colwise()
                    .maxCoeff();
                for (unsigned int k = 0; k < stress_names.size(); ++k)
                  set(n_components + 5 + k, stresses[k]);
              }
          }
        require_finite(fields, snapshot.time);
        MirroredFields data_out;
        data_out.attach_dof_handler(dof_handler);
        data_out.add_data_vector(fields, field_names);
        data_out.add_data_vector(element_errors,
                                 "element_error",
                                 MirroredFields::type_cell_data);
        data_out.build_patches(curved_mapping(),
                               2,
                               DataOut<2>::CurvedCellRegion::curved_boundary);
        if (plate.is_symmetric()[0])
          data_out.mirror(0, {"rotation_x", "moment_xy", "shear_force_x"});
        if (plate.is_symmetric()[1])
          data_out.mirror(1, {"rotation_y", "moment_xy", "shear_force_y"});
        const std::string name =
          "fields_" + std::to_string(record.size()) + ".vtu";
        directory.write_file(name, [&](std::ostream &out) {
          data_out.write_vtu(out);
        });
        record.push_back({snapshot.time, name});
      }
    directory.write_file("fields.pvd", [&](std::ostream &out) {
      DataOutBase::write_pvd_record(out, record);
    });
  }



  nlohmann::ordered_json
  Output::write_summary(const std::string              &outcome,
                        const std::vector<std::string> &warnings,
                        const Verdict                  &verdict)
  {
    nlohmann::ordered_json summary;
    summary["scene"]   = scene.name;
    summary["version"] = PLATE_IMPACT_VERSION;
    summary["outcome"] = outcome;
    const auto part    = [](const Verdict::Part &part) {
      return nlohmann::ordered_json{{"trust", word_for(part.trust)},
                                    {"reasons", part.reasons}};
    };
    summary["verdict"] = {{"trust", word_for(verdict.trust())},
                          {"text", verdict.text},
                          {"convergence", part(verdict.convergence)},
                          {"model", part(verdict.model)}};
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
      write_fields(last);
    clock.charge(last.result.seconds.output);
    cycles.back() = summary_of(last.result, scene.parameters);
    const nlohmann::ordered_json summary =
      write_summary(word_for(outcome), warnings, verdict);
    if (scene.parameters.output.write_report)
      directory.write_file("report.html", [&](std::ostream &out) {
        report.write(out,
                     summary,
                     deflection_film(scene.parameters,
                                     last.result,
                                     last.discretization()));
      });
  }



  void
  Output::write_failure(const std::string &failure)
  {
    try
      {
        write_summary("failed: " + failure,
                      {},
                      {"the computation has failed",
                       {Trust::none, {failure}},
                       {}});
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



  std::string
  Output::main_files() const
  {
    std::string text;
    for (const std::string name : {"report.html",
                                   "comparison.html",
                                   "comparison.csv",
                                   "comparison.json",
                                   "summary.json",
                                   "contact_history.csv",
                                   "fields.pvd"})
      if (fs::exists(directory / name))
        text += (text.empty() ? "" : ", ") + (directory / name).string();
    return text;
  }
} // namespace PlateImpact
