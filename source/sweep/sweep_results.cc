#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/base/version.h"
#include "plate_impact/output/report.h"
#include "plate_impact/sweep/sweep.h"

#include <algorithm>
#include <regex>

namespace PlateImpact
{
  namespace
  {
    /// A sentence without its numbers and the prefixes of their units.
    std::string
    kind_of(const std::string &sentence)
    {
      static const std::regex number("[0-9][0-9.]*(e[-+]?[0-9]+)?"),
        prefix("# (p|n|µ|m|k|M|G|T)(m|s|N|J|Pa)\\b");
      return std::regex_replace(std::regex_replace(sentence, number, "#"),
                                prefix,
                                "# $2");
    }



    /// Numbers of all quantities together, so that a page stays below some
    /// megabytes. Of very large sweeps it has the first quantities only.
    constexpr std::size_t most_page_numbers = 500000;

    /// Figures of the impacts as columns.
    Json
    quantities_on_page(const std::vector<std::optional<SweepRow>> &rows)
    {
      const std::size_t n =
        std::clamp<std::size_t>(most_page_numbers / rows.size(),
                                1,
                                impact_quantities.size());
      Json quantities = Json::array();
      for (std::size_t i = 0; i < n; ++i)
        {
          const ImpactQuantity &quantity = impact_quantities[i];
          std::vector<double>   values;
          for (const auto &row : rows)
            values.push_back(row->failure.empty() ? row->quantities[i] :
                                                    std::nan(""));
          quantities.push_back({{"name", quantity.name},
                                {"title", quantity.title},
                                {"unit", quantity.unit},
                                {"values", numbers_on_page(values)}});
        }
      return quantities;
    }
  } // namespace



  std::vector<std::string>
  sweep_warnings(const std::vector<std::optional<SweepRow>> &rows)
  {
    // by sentences without numbers: the first one, and how many points have it
    nlohmann::ordered_map<std::string, std::pair<std::string, std::size_t>>
               kinds;
    const auto count = [&](const std::string &kind, const std::string &text) {
      auto &[first, n_points] = kinds[kind];
      if (n_points++ == 0)
        first = text;
    };
    // first, and no sentence of a warning: none begins with a blank
    const std::string failed = " failed";
    for (const auto &row : rows)
      if (!row->failure.empty())
        count(failed, row->failure);
    for (const auto &row : rows)
      for (const std::string &warning : row->warnings)
        count(kind_of(warning), warning);

    std::vector<std::string> warnings;
    for (const auto &[name, kind] : kinds)
      warnings.push_back(fmt::format("{} of {} points{}; the first: {}",
                                     kind.second,
                                     rows.size(),
                                     name == failed ? failed : "",
                                     kind.first));
    return warnings;
  }



  std::string
  sweep_page(const SweepScene                           &scene,
             const std::vector<std::optional<SweepRow>> &rows,
             const SweepWork                            &work)
  {
    const SweepPlan &plan  = scene.plan;
    Json             study = {{"study", "sweep"},
                              {"version", PLATE_IMPACT_VERSION},
                              {"text", scene.text},
                              {"isProduct", plan.is_product},
                              {"warnings", sweep_warnings(rows)},
                              {"warned", Json::array()},
                              {"histories", Json::array()},
                              {"quantities", quantities_on_page(rows)},
                              {"work",
                               {{"meshes", work.meshes},
                                {"plates", work.plates},
                                {"loads", work.loads}}}};
    for (const SweptEntry &entry : plan.entries)
      study["entries"].push_back(
        {{"path", entry.path}, {"unit", entry.unit}, {"values", entry.values}});
    for (const auto &row : rows)
      {
        study["statuses"].push_back(row->failure.empty() ? "ok" : row->failure);
        if (!row->warnings.empty())
          study["warned"].push_back(row->point);
        if (row->history.states.empty())
          continue;
        study["histories"].push_back(history_on_page(row->history));
        study["histories"].back()["point"] = row->point;
      }
    study["words"].push_back("The scene, except for the swept entries: " +
                             scene_in_words(scene.parameters));
    if (scene.plan.may_adapt(scene.parameters))
      study["words"].push_back(
        scene.parameters.sweep.adapts_each_point ?
          "Every point has a mesh of its own." :
          "The points of a plate share the mesh that was adapted for the one "
          "with the shortest contact.");
    return page(
      {scene.name,
       std::to_string(rows.size()) + " impacts: " + plan.names() +
         (plan.entries.size() > 1 && !plan.is_product ? ", paired up" : ""),
       "sweep.csv has the peak force and other quantities of all points."},
      study);
  }
} // namespace PlateImpact
