#include "plate_impact/base/entries.h"
#include "plate_impact/base/version.h"
#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/output/report.h"

#include <algorithm>
#include <ostream>

namespace PlateImpact
{
  namespace
  {
    /// Columns of comparison.csv after strategy and element.
    const std::string columns_of_meshes =
      "cycle,cells,degrees_of_freedom,discretization_error,peak_force,"
      "peak_force_error,peak_force_error_bar,contact_end_error,seconds,"
      "cumulative_seconds,cells_at_minimum_size";



    void
    add(Json &json, const std::string &key, const std::optional<double> &value)
    {
      if (value)
        json[key] = *value;
    }



    Json
    to_json(const Reference &reference)
    {
      Json json = {{"peak_force", reference.peak_force},
                   {"origin", reference.computed ? "computed" : "given"}};
      if (!reference.computed)
        return json;
      const CycleResult &result = *reference.computed;
      json["uncertainty"]       = reference.uncertainty;
      add(json, "time_step_error", result.time_error);
      add(json, "first_contact_end", result.history->first_contact_end());
      json["cells"]                = result.cells;
      json["degrees_of_freedom"]   = result.degrees_of_freedom;
      json["discretization_error"] = result.error->eta;
      json["seconds"]              = reference.seconds;
      return json;
    }



    Json
    to_json(const ComparedMesh &mesh)
    {
      Json json = {{"cycle", mesh.cycle},
                   {"cells", mesh.cells},
                   {"degrees_of_freedom", mesh.degrees_of_freedom},
                   {"cells_at_minimum_size", mesh.cells_at_minimum_size},
                   {"discretization_error", mesh.eta},
                   {"peak_force", mesh.peak_force},
                   {"peak_force_error", mesh.peak_force_error},
                   {"comparable", mesh.is_comparable},
                   {"seconds", mesh.seconds},
                   {"cumulative_seconds", mesh.cumulative_seconds}};
      add(json, "peak_force_error_bar", mesh.peak_force_bar);
      add(json, "contact_end_error", mesh.contact_end_error);
      add(json, "effectivity", mesh.effectivity);
      return json;
    }



    /// Whether neither is ahead: identical meshes, or times that differ by less
    /// than a tenth, as they do from run to run.
    bool
    are_tied(const ComparedMesh &one, const ComparedMesh &other)
    {
      const double ratio = one.cumulative_seconds / other.cumulative_seconds;
      return (one.cycle == other.cycle && one.cells == other.cells &&
              one.peak_force == other.peak_force) ||
        (ratio > 0.9 && ratio < 1. / 0.9);
    }



    Json
    to_json(const ThresholdRow &row)
    {
      Json json = {{"quantity", row.is_of_eta ? "eta" : "peak force error"},
                   {"threshold", row.threshold},
                   {"comparable", row.is_comparable},
                   {"in_words", row.in_words},
                   {"reached", Json::array()}};
      for (const auto &[curve, mesh] : row.achievements)
        {
          const ComparedMesh &first = *row.achievements.front().mesh;
          json["reached"].push_back(
            {{"strategy", name_of(curve->strategy)},
             {"element", word_for(curve->element)},
             {"cycle", mesh->cycle},
             {"cells", mesh->cells},
             {"degrees_of_freedom", mesh->degrees_of_freedom},
             {"cumulative_seconds", mesh->cumulative_seconds},
             {"times_the_fastest",
              mesh->cumulative_seconds / first.cumulative_seconds},
             {"as_fast_as_the_first", are_tied(*mesh, first)}});
        }
      return json;
    }



    /// "105 cells after 0.06 s"
    std::string
    in_words(const ComparedMesh &mesh)
    {
      return std::to_string(mesh.cells) + " cells after " +
        fmt::format("{:.2f} s", mesh.cumulative_seconds);
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



    /// Which strategy reaches a threshold first, each with its fastest element,
    /// and by how much: against uniform meshes, or the next.
    std::string
    in_words(const ThresholdRow                 &row,
             const std::vector<ComparisonCurve> &curves)
    {
      const std::string what = row.is_of_eta ?
        "Eta of " + percentage(row.threshold) :
        percentage(row.threshold) + " of the peak force";
      if (!row.is_comparable)
        return what +
          ": not compared, because the reference is not that "
          "accurate.";
      // the fastest curve of every strategy
      std::vector<Achievement> best;
      for (const Achievement &achievement : row.achievements)
        if (std::none_of(best.begin(), best.end(), [&](const Achievement &one) {
              return name_of(one.curve->strategy) ==
                name_of(achievement.curve->strategy);
            }))
          best.push_back(achievement);
      if (best.empty())
        return what + ": not reached.";
      const auto next =
        std::find_if(best.begin() + 1, best.end(), [&](auto &one) {
          return !are_tied(*one.mesh, *best.front().mesh);
        });
      std::string text =
        what + ": " + in_words(std::vector<Achievement>(best.begin(), next));
      const auto is_uniform = [](const ComparisonCurve &curve) {
        return curve.strategy.strategy == AdaptationStrategy::uniform;
      };
      const auto uniform =
        std::find_if(best.begin(), best.end(), [&](auto &one) {
          return is_uniform(*one.curve);
        });
      // uniform meshes are what all are measured by, unless they are first
      const auto other =
        uniform >= next && uniform != best.end() ? uniform : next;
      if (uniform == best.end() &&
          std::any_of(curves.begin(), curves.end(), is_uniform))
        return text + "; uniform meshes do not reach it.";
      if (other != best.end())
        text += "; " + name_of(other->curve->strategy) + ", " +
          in_words(*other->mesh) + ", " +
          rounded(other->mesh->cumulative_seconds /
                    best.front().mesh->cumulative_seconds,
                  2) +
          " times as long";
      return text + '.';
    }



    /// Of curves that reach a threshold and stay below, the fastest first.
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
            return (is_of_eta ? mesh.eta : mesh.peak_force_error) <= threshold;
          };
          auto mesh = curve.meshes.end();
          while (mesh != curve.meshes.begin() && is_reached(mesh[-1]))
            --mesh;
          if (mesh == curve.meshes.end())
            continue;
          // errors of the force change their sign, and may be small by chance
          if (is_of_eta || mesh + 1 != curve.meshes.end() ||
              (mesh->peak_force_bar && *mesh->peak_force_bar <= threshold))
            result.push_back({&curve, &*mesh});
        }
      std::stable_sort(result.begin(), result.end(), [](auto &a, auto &b) {
        return a.mesh->cumulative_seconds < b.mesh->cumulative_seconds;
      });
      return result;
    }
  } // namespace



  std::vector<ThresholdRow>
  StrategyComparison::thresholds() const
  {
    std::vector<ThresholdRow> rows;
    for (const double threshold : {0.05, 0.02, 0.01, 0.005, 0.003, 0.001})
      rows.push_back(
        {false, threshold, threshold > reference.uncertainty, {}, {}});
    for (const double threshold : {0.1, 0.05, 0.02, 0.01})
      rows.push_back({true, threshold, true, {}, {}});
    for (ThresholdRow &row : rows)
      {
        if (row.is_comparable)
          row.achievements = achievements(curves, row.is_of_eta, row.threshold);
        row.in_words = in_words(row, curves);
      }
    return rows;
  }



  Json
  comparison_results(const Scene                    &scene,
                     const StrategyComparison       &comparison,
                     const std::vector<std::string> &warnings)
  {
    Json json = {{"scene", scene.name},
                 {"version", PLATE_IMPACT_VERSION},
                 {"warnings", warnings},
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
    for (const ThresholdRow &row : comparison.thresholds())
      json["thresholds"].push_back(to_json(row));
    return json;
  }



  void
  write_comparison_table(std::ostream                       &out,
                         const std::vector<ComparisonCurve> &curves)
  {
    out << "strategy,element," << columns_of_meshes << '\n';
    for (const ComparisonCurve &curve : curves)
      for (const ComparedMesh &mesh : curve.meshes)
        {
          const Json json = to_json(mesh);
          out << name_of(curve.strategy) << ',' << word_for(curve.element);
          for (const std::string &column : split_list(columns_of_meshes))
            out << ',' << (json.contains(column) ? json[column].dump() : "");
          out << '\n';
        }
  }



  void
  write_comparison_page(std::ostream             &out,
                        const Scene              &scene,
                        const StrategyComparison &comparison,
                        const Json               &results)
  {
    const Reference &reference = comparison.reference;
    const auto       forces = [](const std::optional<ContactHistory> &history) {
      return history ? history_on_page(*history) : Json();
    };
    Json study = {{"study", "comparison"},
                  {"text", scene.text},
                  {"comparison", results},
                  {"target", scene.parameters.adaptivity.target_error},
                  {"meshes", Json::array()}};
    study.update(plate_on_page(scene.parameters));
    for (const ComparisonCurve &curve : comparison.curves)
      {
        study["histories"].push_back(forces(curve.history));
        if (!curve.picture.is_null())
          study["meshes"].push_back(curve.picture);
      }
    study["histories"].push_back(
      forces(reference.computed ? reference.computed->history : std::nullopt));
    write_page(out,
               {"Comparison: " + scene.name,
                "Adaptive strategies side by side: the time and the number of "
                "cells that each needs for a given error.",
                "The peak force of the reference is " +
                  number(reference.peak_force, "N") +
                  "; comparison.csv has the meshes."},
               study);
  }
} // namespace PlateImpact
