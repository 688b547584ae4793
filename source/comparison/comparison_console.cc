#include "plate_impact/comparison/comparison_console.h"

#include "plate_impact/base/text.h"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <unistd.h>

namespace PlateImpact
{
  namespace
  {
    /// Curves listed for a threshold; comparison.html has all.
    constexpr std::size_t n_listed = 4;
  } // namespace



  ComparisonConsole::ComparisonConsole(const bool quiet)
    : progress(quiet)
    , quiet(quiet)
    , out(STDOUT_FILENO)
  {
    std::signal(SIGPIPE, SIG_IGN);
  }



  void
  ComparisonConsole::begin(const Scene &scene)
  {
    const ComparisonParameters &comparison = scene.parameters.comparison;
    n_curves = comparison.strategies.size() * comparison.elements.size();
    if (!quiet)
      std::cout << out.emphasized(scene.name, Emphasis::bold)
                << "\nComputing the reference" << std::endl;
  }



  void
  ComparisonConsole::reference(const Reference &reference)
  {
    begin_of_curves = Clock::now();
    if (quiet)
      return;
    progress.clear();
    std::cout << "Reference   " << number(reference.peak_force) << " N";
    if (reference.history)
      std::cout << ", uncertain by " << about_percentage(reference.uncertainty)
                << ": " << reference.cells
                << " cells, eta = " << about_percentage(*reference.eta) << ", "
                << wall_time(reference.seconds);
    else
      std::cout << ", given";
    std::cout
      << "\n\ncycle  cells unknowns  eta % peak force N  error %  +- % seconds"
      << std::endl;
  }



  void
  ComparisonConsole::curve(const ComparedStrategy &strategy,
                           const ElementType       element)
  {
    if (quiet)
      return;
    progress.clear();
    const std::chrono::duration<double> elapsed =
      Clock::now() - begin_of_curves;
    std::cout << n_curves_begun + 1 << " of " << n_curves << "  "
              << word_for(strategy) << ", " << word_for(element);
    if (n_curves_begun > 0)
      std::cout << ", about "
                << waiting_time(elapsed.count() / n_curves_begun *
                                (n_curves - n_curves_begun))
                << " left";
    std::cout << std::endl;
    ++n_curves_begun;
  }



  void
  ComparisonConsole::mesh(const ComparisonCurve &curve)
  {
    if (quiet)
      return;
    progress.clear();
    const ComparedMesh   &mesh = curve.meshes.back();
    std::optional<double> bar;
    if (mesh.peak_force_bar)
      bar = 100. * *mesh.peak_force_bar;
    std::cout << column(5, "{:.0f}", mesh.cycle)
              << column(7, "{:.0f}", mesh.cells)
              << column(9, "{:.0f}", mesh.degrees_of_freedom)
              << column(7, "{:.2f}", 100. * mesh.eta)
              << column(13, "{:.6g}", mesh.peak_force)
              << column(9,
                        mesh.is_comparable ? "{:.4f}" : "({:.4f})",
                        100. * mesh.peak_force_error)
              << column(6, "{:.2g}", bar)
              << column(8, "{:.2f}", mesh.cumulative_seconds) << std::endl;
  }



  void
  ComparisonConsole::curve_end(const ComparisonCurve &curve)
  {
    if (quiet)
      return;
    progress.clear();
    std::cout << "       " << curve.end << std::endl;
  }



  void
  ComparisonConsole::end(const std::vector<ThresholdRow> &rows,
                         const std::vector<std::string>  &warnings,
                         const std::string               &results)
  {
    if (!quiet)
      {
        for (const ThresholdRow &row : rows)
          {
            std::cout << "\n"
                      << row.quantity() << " of " << percentage(row.threshold)
                      << "\n";
            if (!row.is_comparable)
              std::cout << " not compared: the reference is not known that "
                           "well\n";
            else if (row.achievements.empty())
              std::cout << " not reached\n";
            for (std::size_t i = 0;
                 i < std::min(row.achievements.size(), n_listed);
                 ++i)
              {
                const Achievement  &achievement = row.achievements[i];
                const ComparedMesh &mesh        = *achievement.mesh;
                const double        fastest =
                  row.achievements.front().mesh->cumulative_seconds;
                std::cout
                  << ' ' << left(24, word_for(achievement.curve->strategy))
                  << left(12, word_for(achievement.curve->element))
                  << column(6, "{:.0f}", mesh.cells) << " cells"
                  << column(8, "{:.2f}", mesh.cumulative_seconds) << " s"
                  << (i > 0 && are_tied(achievement, row.achievements[i - 1]) ?
                        " as the one before\n" :
                        column(7, "{:.1f}", mesh.cumulative_seconds / fastest) +
                          " times\n");
              }
            if (row.achievements.size() > n_listed)
              std::cout << " and " << row.achievements.size() - n_listed
                        << " more\n";
          }
        std::cout << "\nResults     " << results << std::endl;
      }
    print_warnings(warnings);
  }
} // namespace PlateImpact
