#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/command/commands.h"
#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/marking/outside_marking.h"
#include "plate_impact/output/console.h"
#include "plate_impact/output/result_directory.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    /// What a reader should know before believing the comparison.
    std::vector<std::string>
    warnings_of(const Scene &scene, const StrategyComparison &comparison)
    {
      std::vector<std::string> warnings;
      if (scene.parameters.contact.load_is_singular())
        warnings.push_back(
          "under a point load the peak force does not converge: its errors "
          "only show how far the smallest cell is from that of the reference");
      const Reference &reference = comparison.reference;
      for (const ComparisonCurve &curve : comparison.curves)
        {
          const std::string name = curve.name();
          for (const std::string &warning : curve.warnings)
            warnings.push_back(name + ": " + warning);
          if (curve.end.rfind("failed", 0) == 0)
            warnings.push_back(name + " " + curve.end);
          for (const ComparedMesh &mesh : curve.meshes)
            if (reference.computed && mesh.eta < reference.computed->error->eta)
              {
                warnings.push_back(name + ": cycle " +
                                   std::to_string(mesh.cycle) +
                                   " has a smaller eta than the reference");
                break;
              }
        }
      return warnings;
    }



    std::string
    text_of(const Reference &reference)
    {
      std::string text = "Reference   " + number(reference.peak_force) + " N";
      if (!reference.computed)
        text += ", given";
      else
        text += fmt::format(" +- {} for its mesh: {} cells, eta = {}, {:.2f} s",
                            about_percentage(reference.uncertainty),
                            reference.computed->cells,
                            about_percentage(reference.computed->error->eta),
                            reference.seconds);
      if (reference.computed && reference.computed->time_error)
        text += fmt::format("\nTime step   the same on all meshes, with an "
                            "error of {} of the peak force",
                            about_percentage(*reference.computed->time_error));
      return text +
        "\n\ncycle  cells unknowns  eta % peak force N  error %  +- % seconds\n";
    }



    std::string
    line_of(const ComparedMesh &mesh)
    {
      const auto percent = [](const double fraction) {
        return 100. * fraction;
      };
      return column(5, "{:.0f}", mesh.cycle) + column(7, "{:.0f}", mesh.cells) +
        column(9, "{:.0f}", mesh.degrees_of_freedom) +
        column(7, "{:.2f}", percent(mesh.eta)) +
        column(13, "{:.6g}", mesh.peak_force) +
        column(9,
               mesh.is_comparable ? "{:.4f}" : "({:.4f})",
               percent(mesh.peak_force_error)) +
        column(6,
               "{:.2g}",
               mesh.peak_force_bar ?
                 std::optional(percent(*mesh.peak_force_bar)) :
                 std::nullopt) +
        column(8, "{:.2f}", mesh.cumulative_seconds) + '\n';
    }



    void
    compare(const Scene             &scene,
            const ResultDirectory   &directory,
            Console                 &console,
            const AdaptationControl *marking)
    {
      StrategyComparison comparison{
        scene,
        [&console](const auto cycle, const auto step, const auto n_steps) {
          console.show(column(5, "{:.0f}", cycle) + "  step ", step, n_steps);
        },
        marking};
      const auto write_table = [&] {
        directory.write_file("comparison.csv", [&](std::ostream &out) {
          write_comparison_table(out, comparison.curves);
        });
      };
      console.print(emphasized(scene.name, Emphasis::bold) +
                    "\nComputing the reference\n");
      write_table();
      console.print(text_of(comparison.compute_reference()));
      const ComparisonParameters &parameters = scene.parameters.comparison;
      const std::size_t           n =
        parameters.strategies.size() * parameters.elements.size();
      const dealii::Timer timer;
      for (const ComparedStrategy &strategy : parameters.strategies)
        for (const ElementType element : parameters.elements)
          {
            const std::size_t n_done = comparison.curves.size();
            const std::string left   = n_done > 0 ? ", about " +
                waiting_time(timer.wall_time() / n_done * (n - n_done)) +
                " left" :
                                                    "";
            console.print(fmt::format("{} of {}  {}, {}{}\n",
                                      n_done + 1,
                                      n,
                                      name_of(strategy),
                                      word_for(element),
                                      left));
            const ComparisonCurve &curve =
              comparison.compute_curve(strategy,
                                       element,
                                       [&](const ComparisonCurve &curve) {
                                         write_table();
                                         console.print(
                                           line_of(curve.meshes.back()));
                                       });
            console.print("       " + curve.end + '\n');
            const Json results =
              comparison_results(scene,
                                 comparison,
                                 warnings_of(scene, comparison));
            directory.write_file("comparison.json", [&](std::ostream &out) {
              out << results.dump(2) << '\n';
            });
            directory.write_file("comparison.html", [&](std::ostream &out) {
              write_comparison_page(out, scene, comparison, results);
            });
          }
      if (std::all_of(comparison.curves.begin(),
                      comparison.curves.end(),
                      [](const auto &curve) { return curve.meshes.empty(); }))
        throw ComputationError("no strategy gave a result; " +
                               comparison.curves.front().end);
      console.print("\n");
      for (const ThresholdRow &row : comparison.thresholds())
        for (const std::string &line :
             dealii::Utilities::break_text_into_lines(row.in_words,
                                                      /*width=*/78))
          console.print(line + '\n');
      console.print("\nResults     " + directory.main_files() + '\n');
      print_warnings(warnings_of(scene, comparison));
    }
  } // namespace



  void
  compare_scene(Scene scene, const bool quiet, const std::string &command)
  {
    if (!scene.parameters.has_impactor())
      throw InputError(
        {scene.name + ": Impactor/Shape = none has no force to compare"});
    Console               console(quiet);
    const ResultDirectory directory(scene.parameters.output.directory);
    directory.clear();
    directory.write_scene(scene.name, scene.text);
    std::unique_ptr<OutsideMarking> marking;
    if (!command.empty())
      {
        marking = std::make_unique<OutsideMarking>(command,
                                                   scene.parameters.adaptivity,
                                                   directory);
        scene.parameters.comparison.strategies.push_back(
          {AdaptationStrategy::hanging_nodes,
           AdaptationGoal::energy_norm,
           /*is_outside=*/true});
      }
    try
      {
        compare(scene, directory, console, marking.get());
      }
    catch (const Interruption &interruption)
      {
        throw interruption.with(
          "the meshes so far are in " + directory.main_files() +
          "; to compute the rest, name it in Comparison/Strategies and Elements");
      }
  }
} // namespace PlateImpact
