#include "plate_impact/command/compare.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/interrupt.h"
#include "plate_impact/base/version.h"
#include "plate_impact/comparison/comparison_console.h"
#include "plate_impact/comparison/comparison_page.h"
#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/output/output.h"

#include <nlohmann/json.hpp>

namespace PlateImpact
{
  namespace
  {
    void
    write_csv(std::ostream &out, const std::vector<ComparisonCurve> &curves)
    {
      out.precision(12);
      out
        << "strategy,element,cycle,cells,degrees_of_freedom,"
           "discretization_error,peak_force,peak_force_error,"
           "peak_force_error_bar,contact_end_error,seconds,cumulative_seconds\n";
      for (const ComparisonCurve &curve : curves)
        for (const ComparedMesh &mesh : curve.meshes)
          {
            out << word_for(curve.strategy) << ',' << word_for(curve.element)
                << ',' << mesh.cycle << ',' << mesh.cells << ','
                << mesh.degrees_of_freedom << ',' << mesh.eta << ','
                << mesh.peak_force << ',' << mesh.peak_force_error << ',';
            if (mesh.peak_force_bar)
              out << *mesh.peak_force_bar;
            out << ',';
            if (mesh.contact_end_error)
              out << *mesh.contact_end_error;
            out << ',' << mesh.seconds << ',' << mesh.cumulative_seconds
                << '\n';
          }
    }



    nlohmann::ordered_json
    to_json(const Reference &reference)
    {
      nlohmann::ordered_json json;
      json["peak_force"] = reference.peak_force;
      json["origin"]     = reference.history ? "computed" : "given";
      if (!reference.history)
        return json;
      json["uncertainty"] = reference.uncertainty;
      if (reference.contact_end)
        json["first_contact_end"] = *reference.contact_end;
      json["cells"]                = reference.cells;
      json["degrees_of_freedom"]   = reference.degrees_of_freedom;
      json["discretization_error"] = *reference.eta;
      json["seconds"]              = reference.seconds;
      return json;
    }



    /// What comparison.csv has no column for.
    nlohmann::ordered_json
    to_json(const std::vector<ComparedMesh> &meshes)
    {
      nlohmann::ordered_json json = nlohmann::ordered_json::array();
      for (const ComparedMesh &mesh : meshes)
        {
          json.push_back({{"cycle", mesh.cycle},
                          {"cells", mesh.cells},
                          {"comparable", mesh.is_comparable}});
          if (mesh.effectivity)
            json.back()["effectivity"] = *mesh.effectivity;
        }
      return json;
    }



    nlohmann::ordered_json
    to_json(const ThresholdRow &row)
    {
      nlohmann::ordered_json json;
      json["quantity"]   = row.quantity();
      json["threshold"]  = row.threshold;
      json["comparable"] = row.is_comparable;
      json["reached"]    = nlohmann::ordered_json::array();
      for (const Achievement &achievement : row.achievements)
        json["reached"].push_back(
          {{"strategy", word_for(achievement.curve->strategy)},
           {"element", word_for(achievement.curve->element)},
           {"cycle", achievement.mesh->cycle},
           {"cells", achievement.mesh->cells},
           {"degrees_of_freedom", achievement.mesh->degrees_of_freedom},
           {"cumulative_seconds", achievement.mesh->cumulative_seconds},
           {"times_the_fastest",
            achievement.mesh->cumulative_seconds /
              row.achievements.front().mesh->cumulative_seconds}});
      return json;
    }



    void
    write_json(std::ostream                   &out,
               const Scene                    &scene,
               const StrategyComparison       &comparison,
               const std::vector<std::string> &warnings)
    {
      nlohmann::ordered_json json;
      json["scene"]     = scene.name;
      json["version"]   = PLATE_IMPACT_VERSION;
      json["warnings"]  = warnings;
      json["reference"] = to_json(comparison.reference());
      json["curves"]    = nlohmann::ordered_json::array();
      for (const ComparisonCurve &curve : comparison.curves())
        json["curves"].push_back({{"strategy", word_for(curve.strategy)},
                                  {"element", word_for(curve.element)},
                                  {"end", curve.end},
                                  {"meshes", to_json(curve.meshes)}});
      json["thresholds"] = nlohmann::ordered_json::array();
      for (const ThresholdRow &row : comparison.thresholds())
        json["thresholds"].push_back(to_json(row));
      out << json.dump(2) << '\n';
    }



    /// What a reader should know before believing the comparison.
    std::vector<std::string>
    warnings_of(const Scene &scene, const StrategyComparison &comparison)
    {
      std::vector<std::string> warnings;
      if (scene.parameters.contact.load_is_singular())
        warnings.push_back(
          "under a point load the peak force has no limit: errors tell how "
          "far the smallest cell is from that of the reference");
      const Reference &reference = comparison.reference();
      for (const ComparisonCurve &curve : comparison.curves())
        {
          const std::string name = curve.name();
          for (const std::string &warning : curve.warnings)
            warnings.push_back(name + ": " + warning);
          if (curve.end.rfind("failed", 0) == 0)
            warnings.push_back(name + " " + curve.end);
          for (const ComparedMesh &mesh : curve.meshes)
            if (reference.eta && mesh.eta < *reference.eta)
              {
                warnings.push_back(name + ": cycle " +
                                   std::to_string(mesh.cycle) +
                                   " has a smaller eta than the reference");
                break;
              }
        }
      return warnings;
    }



    void
    compare(const Scene &scene, Output &output, ComparisonConsole &console)
    {
      StrategyComparison comparison(
        scene,
        [&console](const auto cycle, const auto step, const auto n_steps) {
          throw_if_interrupted();
          console.progress.show(cycle, step, n_steps);
        });
      const auto write = [&] {
        output.write_file("comparison.csv", [&](std::ostream &out) {
          write_csv(out, comparison.curves());
        });
      };
      console.begin(scene);
      write();
      console.reference(comparison.compute_reference());
      bool has_meshes = false;
      for (const ComparedStrategy &strategy :
           scene.parameters.comparison.strategies)
        for (const ElementType element : scene.parameters.comparison.elements)
          {
            console.curve(strategy, element);
            const ComparisonCurve &curve =
              comparison.compute_curve(strategy,
                                       element,
                                       [&](const ComparisonCurve &curve) {
                                         write();
                                         console.mesh(curve);
                                       });
            has_meshes = has_meshes || !curve.meshes.empty();
            console.curve_end(curve);
            const auto warnings = warnings_of(scene, comparison);
            output.write_file("comparison.json", [&](std::ostream &out) {
              write_json(out, scene, comparison, warnings);
            });
            output.write_file("comparison.html", [&](std::ostream &out) {
              ComparisonPage(scene, comparison, warnings).write(out);
            });
          }
      if (!has_meshes)
        throw ComputationError("no strategy gave a result; " +
                               comparison.curves().front().end);
      console.end(comparison.thresholds(),
                  warnings_of(scene, comparison),
                  output.main_files());
    }
  } // namespace



  void
  compare_scene(const Scene &scene, const bool quiet)
  {
    if (!scene.parameters.has_impactor())
      throw InputError(
        {scene.name + ": Impactor/Shape = none has no force to compare"});
    ComparisonConsole console(quiet);
    Output            output(scene);
    try
      {
        compare(scene, output, console);
      }
    catch (const Interruption &interruption)
      {
        throw Interruption(
          std::string(interruption.what()) + ": the meshes so far are in " +
            output.main_files() +
            "; Comparison/Strategies and Elements name what is "
            "left",
          interruption.signal);
      }
  }
} // namespace PlateImpact
