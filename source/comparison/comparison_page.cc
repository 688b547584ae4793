#include "plate_impact/comparison/comparison_page.h"

#include "plate_impact/base/text.h"
#include "plate_impact/base/version.h"
#include "plate_impact/comparison/comparison_plots.h"
#include "plate_impact/page/mesh_picture.h"


namespace PlateImpact
{
  namespace
  {
    /// A curve's cell in a table of thresholds.
    std::string
    achieved(const ThresholdRow &row, const ComparisonCurve &curve)
    {
      if (!row.is_comparable)
        return "not compared";
      for (const Achievement &achievement : row.achievements)
        if (achievement.curve == &curve)
          {
            const ComparedMesh &mesh = *achievement.mesh;
            const double        fastest =
              row.achievements.front().mesh->cumulative_seconds;
            return wall_time(mesh.cumulative_seconds) + ", " +
              std::to_string(mesh.cells) + " cells" +
              (are_tied(achievement, row.achievements.front()) ?
                 ", first" :
                 ", " + about(mesh.cumulative_seconds / fastest) + " times");
          }
      return "–";
    }



    /// The curve that is first, or those that are as fast.
    std::string
    first_of(const ThresholdRow &row)
    {
      std::string names;
      for (const Achievement &achievement : row.achievements)
        if (are_tied(achievement, row.achievements.front()))
          names += (names.empty() ? "" : " and ") + achievement.curve->name();
      return names;
    }



    /// The mesh from which on a strategy keeps eta at 5 % or below; null where
    /// there is none.
    const ComparedMesh *
    first_at_five_percent(const std::vector<ThresholdRow> &rows,
                          const ComparedStrategy          &strategy,
                          const ElementType                element)
    {
      for (const ThresholdRow &row : rows)
        if (row.is_of_eta() && row.threshold == 0.05)
          for (const Achievement &achievement : row.achievements)
            if (achievement.curve->strategy == strategy &&
                achievement.curve->element == element)
              return achievement.mesh;
      return nullptr;
    }
  } // namespace



  ComparisonPage::ComparisonPage(const Scene                    &scene,
                                 const StrategyComparison       &comparison,
                                 const std::vector<std::string> &warnings)
    : scene(scene)
    , comparison(comparison)
    , warnings(warnings)
  {}



  void
  ComparisonPage::write(std::ostream &out) const
  {
    Page page("Comparison: " + scene.name,
              "Ways to make the mesh follow the error, side by side: what a "
              "user waits for an error, and how many cells it takes.");
    add_outcome(page);
    add_thresholds(page);
    const ComparisonPlots plots(scene, comparison);
    plots.add_costs(page);
    plots.add_effectivity(page);
    plots.add_histories(page);
    add_meshes(page);
    add_fairness(page);
    add_numbers(page);
    page.section("Scene");
    page.paragraph("plate-impact " PLATE_IMPACT_VERSION
                   "; save as a .prm file and give it to plate-impact compare "
                   "to repeat the comparison.");
    page.preformatted(scene.text);
    page.write(out);
  }



  void
  ComparisonPage::add_outcome(Page &page) const
  {
    page.section("Outcome");
    for (const std::string &warning : warnings)
      page.notice("Warning: " + warning);
    const Reference   &reference = comparison.reference();
    const PrefixedUnit unit("N", reference.peak_force);
    std::vector<Fact>  facts = {
       {"Reference peak force",
        number(unit(reference.peak_force)) + ' ' + unit.name(),
       reference.history ?
          "uncertain by " + about_percentage(reference.uncertainty) + ": " +
           std::to_string(reference.cells) +
           " cells, η = " + about_percentage(*reference.eta) :
          "given by the scene"}};
    const std::vector<ThresholdRow> rows = comparison.thresholds();
    for (const ThresholdRow &row : rows)
      if (!row.is_of_eta() && !row.achievements.empty() &&
          (row.threshold == 0.01 || row.threshold == 0.001))
        facts.push_back(
          {"First at " + about_percentage(row.threshold),
           first_of(row),
           wall_time(row.achievements.front().mesh->cumulative_seconds) + ", " +
             std::to_string(row.achievements.front().mesh->cells) + " cells"});
    page.facts(facts);
  }



  void
  ComparisonPage::add_thresholds(Page &page) const
  {
    page.section("Who is first");
    page.paragraph(
      "Seconds until an error is reached and kept on all later meshes, the "
      "cells of that mesh, and how many times the seconds of the fastest.");
    for (const bool is_of_eta : {false, true})
      {
        Table table;
        table.has_words = true;
        table.columns   = {is_of_eta ? "η" : "Error of the peak force"};
        std::vector<ThresholdRow> rows;
        for (const ThresholdRow &row : comparison.thresholds())
          if (row.is_of_eta() == is_of_eta)
            {
              rows.push_back(row);
              table.columns.push_back(about_percentage(row.threshold));
            }
        for (const ComparisonCurve &curve : comparison.curves())
          {
            table.rows.push_back({curve.name()});
            for (const ThresholdRow &row : rows)
              table.rows.back().push_back(achieved(row, curve));
          }
        page.table(table);
      }
  }



  void
  ComparisonPage::add_meshes(Page &page) const
  {
    std::vector<MeshPicture> pictures;
    for (const ComparisonCurve &curve : comparison.curves())
      if (curve.picture)
        pictures.push_back(*curve.picture);
    if (pictures.empty())
      return;
    page.section("Meshes");
    page.paragraph("The first mesh of each curve whose η is at most " +
                   about_percentage(scene.parameters.adaptivity.target_error) +
                   ", or its last that can be drawn. " +
                   meshed_part_in_words(scene.parameters.plate));
    page.meshes(pictures);
  }



  void
  ComparisonPage::add_fairness(Page &page) const
  {
    page.section("What is compared");
    page.paragraph(
      "All curves share the initial cells, which those by force refine "
      "towards the load, time step, integrator, linear "
      "solver, load and error estimator. Whenever η meets the target error, "
      "the target is halved, so that every curve goes on to smaller errors. "
      "The cost of a mesh is what a user waits for it: assembly, transient, "
      "estimation and adaptation of its own cycle and of all before it; the "
      "start of the program is left out. Errors are those of the mesh: the "
      "reference has the same time step.");
    Table table;
    table.columns                        = {"Element",
                                            "hanging nodes [cells]",
                                            "remeshing [cells]",
                                            "hanging nodes η [%]",
                                            "remeshing η [%]"};
    const std::vector<ThresholdRow> rows = comparison.thresholds();
    for (const ElementType element : scene.parameters.comparison.elements)
      {
        const ComparedMesh
          *halved   = first_at_five_percent(rows,
                                          {AdaptationStrategy::hanging_nodes,
                                             AdaptationGoal::energy_norm},
                                          element),
          *remeshed = first_at_five_percent(rows,
                                            {AdaptationStrategy::remeshing,
                                             AdaptationGoal::energy_norm},
                                            element);
        if (halved != nullptr && remeshed != nullptr)
          table.rows.push_back({word_for(element),
                                std::to_string(halved->cells),
                                std::to_string(remeshed->cells),
                                rounded(100. * halved->eta),
                                rounded(100. * remeshed->eta)});
      }
    page.paragraph(
      "Hanging nodes halve sizes: a cell that needs a little less than its "
      "size gets half of it, up to four times the cells. Remeshing gives any "
      "size, but its cells are no parallelograms, on which elements of eight "
      "nodes (serendipity, and the deflection of heterosis) lose an order "
      "(Arnold, Boffi & Falk 2002); compare the strategies with MITC9 or "
      "Lagrange as well. The first meshes at η of at most 5 % show both "
      "effects:");
    if (!table.rows.empty())
      page.table(table);
  }



  void
  ComparisonPage::add_numbers(Page &page) const
  {
    page.section("All meshes");
    page.paragraph("Errors in parentheses are not above the uncertainty of the "
                   "reference. The effectivity is η over the error in energy "
                   "against the reference, where that is three times better. "
                   "comparison.csv has all digits.");
    Table table;
    table.columns = {"Strategy and element",
                     "Cycle",
                     "Cells",
                     "Unknowns",
                     "η [%]",
                     "Peak force [N]",
                     "Error [%]",
                     "Error bar [%]",
                     "Error of contact end [%]",
                     "Effectivity",
                     "Seconds",
                     "So far [s]"};
    for (const ComparisonCurve &curve : comparison.curves())
      for (const ComparedMesh &mesh : curve.meshes)
        {
          const std::string error = rounded(100. * mesh.peak_force_error);
          table.rows.push_back(
            {curve.name(),
             std::to_string(mesh.cycle),
             std::to_string(mesh.cells),
             std::to_string(mesh.degrees_of_freedom),
             rounded(100. * mesh.eta),
             number(mesh.peak_force),
             mesh.is_comparable ? error : "(" + error + ")",
             mesh.peak_force_bar ? rounded(100. * *mesh.peak_force_bar) : "–",
             mesh.contact_end_error ? rounded(100. * *mesh.contact_end_error) :
                                      "–",
             mesh.effectivity ? rounded(*mesh.effectivity) : "–",
             rounded(mesh.seconds),
             rounded(mesh.cumulative_seconds)});
        }
    table.is_sortable = true;
    page.table(table);
    Table ends;
    ends.has_words = true;
    ends.columns   = {"Strategy and element", "Ends with"};
    for (const ComparisonCurve &curve : comparison.curves())
      ends.rows.push_back({curve.name(), curve.end});
    page.table(ends);
  }
} // namespace PlateImpact
