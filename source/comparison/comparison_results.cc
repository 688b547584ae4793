#include "plate_impact/base/entries.h"
#include "plate_impact/base/version.h"
#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/output/report.h"

#include <algorithm>

namespace PlateImpact
{
  namespace
  {
    /// Columns of comparison.csv after strategy and element.
    const std::string columns_of_meshes =
      "cycle,cells,degrees_of_freedom,discretization_error,peak_force,"
      "peak_force_error,peak_force_error_bar,contact_end_error,seconds,"
      "cumulative_seconds,cells_at_minimum_size";



    Json
    to_json(const Reference &reference)
    {
      Json json = {{"peak_force", reference.peak_force},
                   {"origin", reference.computed ? "computed" : "given"}};
      if (!reference.computed)
        return json;
      const CycleResult &result = *reference.computed;
      json["uncertainty"]       = reference.uncertainty;
      add_known(json, "time_step_error", result.time_error);
      add_known(json, "first_contact_end", result.history->end_of_impact());
      json["cells"]                = result.cells;
      json["degrees_of_freedom"]   = result.degrees_of_freedom;
      json["discretization_error"] = result.error->eta;
      json["seconds"]              = result.cumulative_seconds();
      return json;
    }



    Json
    to_json(const ComparedMesh &mesh)
    {
      Json json = {{"cycle", mesh.cycle},
                   {"cells", mesh.cells},
                   {"degrees_of_freedom", mesh.degrees_of_freedom},
                   {"cells_at_minimum_size", mesh.cells_at_minimum_size},
                   {"discretization_error", mesh.error->eta},
                   {"peak_force", mesh.history->peak().force},
                   {"peak_force_error", mesh.peak_force_error},
                   {"comparable", mesh.is_comparable},
                   {"seconds", mesh.seconds.total()},
                   {"cumulative_seconds", mesh.cumulative_seconds()}};
      if (mesh.peak_force_bar)
        json["peak_force_error_bar"] = mesh.peak_force_bar->total();
      add_known(json, "contact_end_error", mesh.contact_end_error);
      add_known(json, "effectivity", mesh.effectivity);
      return json;
    }



    /// A mesh from which on a curve stays below a threshold: of the force,
    /// confirmed by a later mesh or by its own bar.
    struct Achievement
    {
      const ComparisonCurve *curve;
      const ComparedMesh    *mesh;
    };



    /// Of curves that reach a threshold and stay below, the fastest first. Of
    /// eta, those whose meshes are made for it: by force, a plate is watched up
    /// to its peak.
    std::vector<Achievement>
    achievements(const std::vector<ComparisonCurve> &curves,
                 const bool                          is_of_eta,
                 const double                        threshold)
    {
      std::vector<Achievement> result;
      for (const ComparisonCurve &curve : curves)
        {
          if (is_of_eta && curve.strategy.goal == AdaptationGoal::peak_force)
            continue;
          const auto is_reached = [&](const ComparedMesh &mesh) {
            return (is_of_eta ? mesh.error->eta : mesh.peak_force_error) <=
              threshold;
          };
          auto mesh = curve.meshes.end();
          while (mesh != curve.meshes.begin() && is_reached(mesh[-1]))
            --mesh;
          if (mesh == curve.meshes.end())
            continue;
          // errors of the force change their sign, and may be small by chance
          if (is_of_eta || mesh + 1 != curve.meshes.end() ||
              (mesh->peak_force_bar &&
               mesh->peak_force_bar->total() <= threshold))
            result.push_back({&curve, &*mesh});
        }
      std::stable_sort(result.begin(), result.end(), [](auto &a, auto &b) {
        return a.mesh->cumulative_seconds() < b.mesh->cumulative_seconds();
      });
      return result;
    }



    /// How many times as long the first takes as the second.
    double
    ratio_of_times(const ComparedMesh &one, const ComparedMesh &other)
    {
      return one.cumulative_seconds() / other.cumulative_seconds();
    }



    /// Whether neither is ahead: identical meshes, or times that differ by less
    /// than a tenth, as they do from run to run.
    bool
    are_tied(const ComparedMesh &one, const ComparedMesh &other)
    {
      const double ratio = ratio_of_times(one, other);
      return (one.cycle == other.cycle && one.cells == other.cells &&
              one.history->peak().force == other.history->peak().force) ||
        (ratio > 0.9 && ratio < 1. / 0.9);
    }



    /// "105 cells after 0.06 s"
    std::string
    in_words(const ComparedMesh &mesh)
    {
      return fmt::format("{} cells after {:.2f} s",
                         mesh.cells,
                         mesh.cumulative_seconds());
    }



    /// The strategies that are first, and what they need.
    std::string
    in_words(const std::vector<Achievement> &first)
    {
      const bool is_alike =
        std::all_of(first.begin(), first.end(), [&](const Achievement &one) {
          return one.mesh->cells == first.front().mesh->cells;
        });
      std::string text;
      for (std::size_t i = 0; i < first.size(); ++i)
        {
          text += i == 0 ? "" : i + 1 == first.size() ? " and " : ", ";
          text += name_of(first[i].curve->strategy);
          if (!is_alike)
            text += " (" + in_words(*first[i].mesh) + ')';
        }
      text += first.size() > 1 ? " tie" : "";
      return is_alike ? text + ", " + in_words(*first.front().mesh) : text;
    }



    /// Which strategy is first, each with its fastest element, and by how much:
    /// against uniform meshes, or the next.
    /// @param reached  the fastest first
    std::string
    in_words(const std::vector<Achievement>     &reached,
             const std::vector<ComparisonCurve> &curves)
    {
      // the fastest curve of every strategy
      std::vector<Achievement> best;
      for (const Achievement &achievement : reached)
        if (std::none_of(best.begin(), best.end(), [&](const Achievement &one) {
              return one.curve->strategy == achievement.curve->strategy;
            }))
          best.push_back(achievement);
      if (best.empty())
        return "not reached.";
      const auto next =
        std::find_if(best.begin() + 1, best.end(), [&](auto &one) {
          return !are_tied(*one.mesh, *best.front().mesh);
        });
      const std::string text =
        in_words(std::vector<Achievement>(best.begin(), next));
      const auto is_uniform = [](const ComparisonCurve &curve) {
        return curve.strategy.strategy == AdaptationStrategy::uniform;
      };
      const auto uniform =
        std::find_if(best.begin(), best.end(), [&](auto &one) {
          return is_uniform(*one.curve);
        });
      if (uniform == best.end() &&
          std::any_of(curves.begin(), curves.end(), is_uniform))
        return text + "; uniform meshes do not reach it.";
      // uniform meshes are what all are measured by, unless they are first
      const auto other =
        uniform >= next && uniform != best.end() ? uniform : next;
      if (other == best.end())
        return text + '.';
      return text + "; " + name_of(other->curve->strategy) + ", " +
        in_words(*other->mesh) + ", " +
        rounded(ratio_of_times(*other->mesh, *best.front().mesh), 2) +
        " times as long.";
    }



    /// Who reaches a threshold of eta, or of the error of the peak force;
    /// nobody where the reference is not that accurate.
    Json
    threshold_row(const StrategyComparison &comparison,
                  const bool                is_of_eta,
                  const double              threshold)
    {
      const bool is_comparable =
        is_of_eta || threshold > comparison.reference.uncertainty;
      const std::vector<Achievement> reached = is_comparable ?
        achievements(comparison.curves, is_of_eta, threshold) :
        std::vector<Achievement>();
      const std::string              what    = is_of_eta ?
                        "Eta of " + percentage(threshold) :
                        percentage(threshold) + " of the peak force";
      const std::string              words   = is_comparable ?
                       in_words(reached, comparison.curves) :
                       "not compared, because the reference is not that accurate.";
      Json json = {{"quantity", is_of_eta ? "eta" : "peak force error"},
                   {"threshold", threshold},
                   {"comparable", is_comparable},
                   {"in_words", what + ": " + words},
                   {"reached", Json::array()}};
      for (const auto &[curve, mesh] : reached)
        {
          const ComparedMesh &first = *reached.front().mesh;
          json["reached"].push_back(
            {{"strategy", name_of(curve->strategy)},
             {"element", word_for(curve->element)},
             {"cycle", mesh->cycle},
             {"cells", mesh->cells},
             {"degrees_of_freedom", mesh->degrees_of_freedom},
             {"cumulative_seconds", mesh->cumulative_seconds()},
             {"times_the_fastest", ratio_of_times(*mesh, first)},
             {"as_fast_as_the_first", are_tied(*mesh, first)}});
        }
      return json;
    }



    /// What a reader should know before believing the comparison.
    std::vector<std::string>
    warnings_of(const StrategyComparison &comparison)
    {
      std::vector<std::string> warnings;
      if (comparison.scene.parameters.contact.load_is_singular())
        warnings.push_back(
          "under a point load the peak force does not converge: its errors "
          "only show how far the smallest cell is from that of the reference");
      const auto &fine = comparison.reference.computed;
      for (const ComparisonCurve &curve : comparison.curves)
        {
          const std::string name = curve.name();
          for (const std::string &warning : curve.warnings)
            warnings.push_back(name + ": " + warning);
          if (curve.end.rfind("failed", 0) == 0)
            warnings.push_back(name + " " + curve.end);
          for (const ComparedMesh &mesh : curve.meshes)
            if (fine && mesh.error->eta < fine->error->eta)
              {
                warnings.push_back(name + ": cycle " +
                                   std::to_string(mesh.cycle) +
                                   " has a smaller eta than the reference");
                break;
              }
        }
      return warnings;
    }
  } // namespace



  Json
  comparison_results(const StrategyComparison &comparison)
  {
    Json json = {{"scene", comparison.scene.name},
                 {"version", PLATE_IMPACT_VERSION},
                 {"warnings", warnings_of(comparison)},
                 {"reference", to_json(comparison.reference)},
                 {"curves", Json::array()},
                 {"thresholds", Json::array()}};
    for (const ComparisonCurve &curve : comparison.curves)
      {
        json["curves"].push_back({{"strategy", name_of(curve.strategy)},
                                  {"element", word_for(curve.element)},
                                  {"end", curve.end},
                                  {"meshes", Json::array()}});
        for (const ComparedMesh &mesh : curve.meshes)
          json["curves"].back()["meshes"].push_back(to_json(mesh));
      }
    for (const double threshold : {0.05, 0.02, 0.01, 0.005, 0.003, 0.001})
      json["thresholds"].push_back(threshold_row(comparison, false, threshold));
    for (const double threshold : {0.1, 0.05, 0.02, 0.01})
      json["thresholds"].push_back(threshold_row(comparison, true, threshold));
    return json;
  }



  std::string
  comparison_table(const std::vector<ComparisonCurve> &curves)
  {
    std::string text = "strategy,element," + columns_of_meshes + '\n';
    for (const ComparisonCurve &curve : curves)
      for (const ComparedMesh &mesh : curve.meshes)
        {
          const Json json = to_json(mesh);
          text += name_of(curve.strategy) + ',' + word_for(curve.element);
          for (const std::string &column : split_list(columns_of_meshes))
            text += ',' + (json.contains(column) ? json[column].dump() : "");
          text += '\n';
        }
    return text;
  }



  std::string
  comparison_page(const StrategyComparison &comparison, const Json &results)
  {
    const Scene     &scene     = comparison.scene;
    const Reference &reference = comparison.reference;
    Json             study     = {{"study", "comparison"},
                                  {"text", scene.text},
                                  {"comparison", results},
                                  {"target", scene.parameters.adaptivity.target_error},
                                  {"meshes", Json::array()}};
    study.update(plate_on_page(scene.parameters));
    for (const ComparisonCurve &curve : comparison.curves)
      {
        study["histories"].push_back(
          curve.meshes.empty() ? Json() :
                                 history_on_page(*curve.meshes.back().history));
        if (!curve.picture.is_null())
          study["meshes"].push_back(curve.picture);
      }
    study["histories"].push_back(
      reference.computed ? history_on_page(*reference.computed->history) :
                           Json());
    return page({"Comparison: " + scene.name,
                 "Adaptive strategies side by side: the time and the number of "
                 "cells that each needs for a given error.",
                 "The peak force of the reference is " +
                   number(reference.peak_force, "N") +
                   "; comparison.csv has the meshes."},
                study);
  }
} // namespace PlateImpact
