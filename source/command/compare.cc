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
#include <string>

namespace PlateImpact
{
  namespace
  {
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
                            reference.computed->cumulative_seconds());
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
      return column(5, "{:.0f}", mesh.cycle) + column(7, "{:.0f}", mesh.cells) +
        column(9, "{:.0f}", mesh.degrees_of_freedom) +
        column(7, "{:.2f}", 100. * mesh.error->eta) +
        column(13, "{:.6g}", mesh.history->peak().force) +
        column(9,
               mesh.is_comparable ? "{:.4f}" : "({:.4f})",
               100. * mesh.peak_force_error) +
        column(6,
               "{:.2g}",
               mesh.peak_force_bar ? 100. * mesh.peak_force_bar->total() :
                                     std::nan("")) +
        column(8, "{:.2f}", mesh.cumulative_seconds()) + '\n';
    }



    void
    compare(const Scene           &scene,
            const ResultDirectory &directory,
            Console               &console,
            const Marking         &marking)
    {
      StrategyComparison comparison{scene};
      comparison.marking     = marking;
      const auto write_table = [&] {
        directory.write_file("comparison.csv",
                             comparison_table(comparison.curves));
      };
      comparison.listener.step =
        [&](const auto cycle, const auto step, const auto n_steps) {
          console.show(column(5, "{:.0f}", cycle) + "  step ", step, n_steps);
        };
      comparison.listener.cycle = [&](const Cycle &) {
        write_table();
        console.print(line_of(comparison.curves.back().meshes.back()));
      };
      console.print(emphasized(scene.name, fmt::emphasis::bold) +
                    "\nComputing the reference\n");
      write_table();
      console.print(text_of(comparison.compute_reference()));
      const ComparisonParameters &parameters = scene.parameters.comparison;
      const std::size_t           n =
        parameters.strategies.size() * parameters.elements.size();
      const dealii::Timer timer;
      Json                results;
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
            console.print("       " +
                          comparison.compute_curve(strategy, element).end +
                          '\n');
            results = comparison_results(comparison);
            directory.write_file("comparison.json", results.dump(2) + '\n');
            directory.write_file("comparison.html",
                                 comparison_page(comparison, results));
          }
      if (std::all_of(comparison.curves.begin(),
                      comparison.curves.end(),
                      [](const auto &curve) { return curve.meshes.empty(); }))
        throw ComputationError("no strategy gave a result; " +
                               comparison.curves.front().end);
      console.print("\n");
      for (const Json &row : results["thresholds"])
        for (const std::string &line :
             dealii::Utilities::break_text_into_lines(row["in_words"],
                                                      /*width=*/78))
          console.print(line + '\n');
      console.print("\nResults     " + directory.main_files() + '\n');
      print_warnings(results["warnings"]);
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
    if (!command.empty())
      scene.parameters.comparison.strategies.push_back(
        {AdaptationStrategy::hanging_nodes,
         AdaptationGoal::energy_norm,
         /*is_outside=*/true});
    try
      {
        compare(scene, directory, console, outside_marking(command, directory));
      }
    catch (const Interruption &interruption)
      {
        throw interruption.with(
          "the meshes so far are in " + directory.main_files() +
          "; to compute the rest, name it in Comparison/Strategies and Elements");
      }
  }
} // namespace PlateImpact
