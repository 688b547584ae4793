#include "plate_impact/sweep/sweep_page.h"

#include "plate_impact/analysis/impact_figures.h"
#include "plate_impact/base/text.h"
#include "plate_impact/base/version.h"
#include "plate_impact/output/run_in_words.h"
#include "plate_impact/sweep/sweep_warnings.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace PlateImpact
{
  namespace
  {
    /// Rows of the table of the page.
    constexpr std::size_t most_rows = 200;
  } // namespace



  SweepPage::SweepPage(const SweepScene                            &scene,
                       const std::vector<std::optional<SweepRow>>  &rows,
                       const std::map<std::size_t, ContactHistory> &histories)
    : scene(scene)
    , plan(scene.plan())
    , rows(rows)
    , plots(plan, rows, histories)
  {}



  void
  SweepPage::write_facts(Page &page, const SweepWork &work) const
  {
    const auto n_failed =
      std::count_if(rows.begin(), rows.end(), [](const auto &row) {
        return !row->failure.empty();
      });
    const auto n_warned =
      std::count_if(rows.begin(), rows.end(), [](const auto &row) {
        return !row->warnings.empty();
      });
    page.section("Outcome");
    std::vector<Fact> facts = plots.smallest_and_largest_force();
    facts.push_back({"Points",
                     std::to_string(rows.size()),
                     "failed: " + std::to_string(n_failed) +
                       ", with warnings: " + std::to_string(n_warned)});
    facts.push_back({"Meshes",
                     std::to_string(work.meshes),
                     "plate models: " + std::to_string(work.plates) +
                       ", responses to a load: " + std::to_string(work.loads)});
    page.facts(facts);
    for (const std::string &warning : sweep_warnings(rows))
      page.notice("Warning: " + warning);
    page.paragraph("The scene, but for what is swept: " +
                   scene_in_words(scene.parameters()));
    if (scene.may_adapt())
      page.paragraph(scene.parameters().sweep.adapt ==
                         SweepAdaptation::each_point ?
                       "Every point has a mesh of its own." :
                       "The points of a plate share the mesh that was adapted "
                       "for the one with the shortest contact.");
    page.paragraph(
      "Models and responses are those of the computation that ended this "
      "sweep; points that share plate, mesh and load share them.");
  }



  void
  SweepPage::write_table(Page &page) const
  {
    page.section("Table");
    Table table;
    for (const SweptEntry &entry : plan.entries())
      table.columns.push_back(with_unit(entry.path, entry.unit));
    for (const Figure &figure : impact_figures())
      table.columns.push_back(with_unit(figure.title, figure.unit));
    table.columns.push_back("Status");
    table.has_words = true;
    for (std::size_t point = 0; point < std::min(rows.size(), most_rows);
         ++point)
      {
        std::vector<std::string> row = plan.values(point);
        for (std::size_t i = 0; i < impact_figures().size(); ++i)
          row.push_back(
            rows[point]->failure.empty() ?
              number(rows[point]->figures[i].value_or(std::nan(""))) :
              "–");
        row.push_back(!rows[point]->failure.empty()   ? rows[point]->failure :
                        rows[point]->warnings.empty() ? "ok" :
                                                        "ok, with warnings");
        table.rows.push_back(row);
      }
    page.table(table);
    if (rows.size() > most_rows)
      page.paragraph("The first " + std::to_string(most_rows) + " of " +
                     std::to_string(rows.size()) +
                     " points; all of them are in sweep.csv.");
  }



  void
  SweepPage::write(std::ostream &out, const SweepWork &work) const
  {
    std::string names;
    for (const SweptEntry &entry : plan.entries())
      names += (names.empty() ? "" : ", ") + entry.path;
    Page page(scene.name(),
              std::to_string(rows.size()) + " impacts: " + names +
                (plan.entries().size() > 1 && !plan.forms_product() ?
                   ", paired up" :
                   ""));
    write_facts(page, work);
    plots.add_figures(page);
    plots.add_histories(page);
    write_table(page);
    page.section("Scene");
    page.preformatted(scene.text());
    page.paragraph("plate-impact " PLATE_IMPACT_VERSION);
    page.write(out);
  }
} // namespace PlateImpact
