#include "plate_impact/sweep/sweep_page.h"

#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/base/text.h"
#include "plate_impact/base/version.h"
#include "plate_impact/output/report.h"
#include "plate_impact/output/run_in_words.h"
#include "plate_impact/page/page.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

namespace PlateImpact
{
  namespace
  {
    /// Numbers of all figures together, so that a page stays below some
    /// megabytes. Of very large sweeps it has the first figures only.
    constexpr std::size_t most_numbers = 500000;

    /// States of a history; more do not show.
    constexpr std::size_t most_states = 1000;



    /// Figures of the impacts as columns.
    Json
    figures_on_page(const std::vector<std::optional<SweepRow>> &rows)
    {
      const std::size_t n = std::clamp<std::size_t>(most_numbers / rows.size(),
                                                    1,
                                                    impact_quantities().size());
      Json              figures = Json::array();
      for (std::size_t i = 0; i < n; ++i)
        {
          const ImpactQuantity &figure = impact_quantities()[i];
          std::vector<double>   values;
          for (const auto &row : rows)
            values.push_back(row->failure.empty() ? row->figures[i] :
                                                    std::nan(""));
          figures.push_back({{"name", figure.name},
                             {"title", figure.title},
                             {"unit", figure.unit},
                             {"values", numbers_on_page(values)}});
        }
      return figures;
    }
  } // namespace



  void
  write_sweep_page(std::ostream                                &out,
                   const SweepScene                            &scene,
                   const std::vector<std::optional<SweepRow>>  &rows,
                   const std::map<std::size_t, ContactHistory> &histories,
                   const SweepWork                             &work)
  {
    const SweepPlan &plan = scene.plan();
    std::string      names;
    Json             study = {{"study", "sweep"},
                              {"version", PLATE_IMPACT_VERSION},
                              {"text", scene.text()},
                              {"isProduct", plan.forms_product()},
                              {"warnings", sweep_warnings(rows)},
                              {"warned", Json::array()},
                              {"histories", Json::array()},
                              {"figures", figures_on_page(rows)},
                              {"work",
                               {{"meshes", work.meshes},
                                {"plates", work.plates},
                                {"loads", work.loads}}}};
    for (const SweptEntry &entry : plan.entries())
      {
        names += (names.empty() ? "" : ", ") + entry.path;
        study["entries"].push_back({{"path", entry.path},
                                    {"unit", entry.unit},
                                    {"values", entry.values}});
      }
    for (const auto &row : rows)
      {
        study["statuses"].push_back(row->failure.empty() ? "ok" : row->failure);
        if (!row->warnings.empty())
          study["warned"].push_back(row->point);
      }
    for (const auto &[point, history] : histories)
      {
        study["histories"].push_back(
          history_on_page(history, most_states, {"time", "force"}));
        study["histories"].back()["point"] = point;
      }
    study["words"].push_back("The scene, but for what is swept: " +
                             scene_in_words(scene.parameters()));
    if (scene.may_adapt())
      study["words"].push_back(
        scene.parameters().sweep.adapt == SweepAdaptation::each_point ?
          "Every point has a mesh of its own." :
          "The points of a plate share the mesh that was adapted for the one "
          "with the shortest contact.");
    write_page(
      out,
      {scene.name(),
       std::to_string(rows.size()) + " impacts: " + names +
         (plan.entries().size() > 1 && !plan.forms_product() ? ", paired up" :
                                                               ""),
       "sweep.csv has the peak force and other figures of all points."},
      study);
  }
} // namespace PlateImpact
