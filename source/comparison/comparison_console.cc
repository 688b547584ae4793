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
    if (!quiet)
      std::cout << out.emphasized(scene.name, Emphasis::bold)
                << "\nComputing the reference" << std::endl;
  }



  void
  ComparisonConsole::reference(const Reference &reference)
  {
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
      << "\n\n strategy        element       cycle      cells   unknowns"
         "     eta %  peak force N   error %   seconds    so far"
      << std::endl;
  }



  void
  ComparisonConsole::mesh(const ComparisonCurve &curve)
  {
    if (quiet)
      return;
    progress.clear();
    const ComparedMesh &mesh = curve.meshes.back();
    std::cout << ' ' << left(16, word_for(curve.strategy))
              << left(12, word_for(curve.element))
              << column(7, "{:.0f}", mesh.cycle)
              << column(11, "{:.0f}", mesh.cells)
              << column(11, "{:.0f}", mesh.degrees_of_freedom)
              << column(10, "{:.2f}", 100. * mesh.eta)
              << column(14, "{:.6g}", mesh.peak_force)
              << column(10,
                        mesh.is_comparable ? "{:.4f}" : "({:.4f})",
                        100. * mesh.peak_force_error)
              << column(10, "{:.2f}", mesh.seconds)
              << column(10, "{:.2f}", mesh.cumulative_seconds) << std::endl;
  }



  void
  ComparisonConsole::curve_end(const ComparisonCurve &curve)
  {
    if (quiet)
      return;
    progress.clear();
    std::cout << " " << std::string(16, ' ') << curve.end << std::endl;
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
                std::cout << ' '
                          << left(16, word_for(achievement.curve->strategy))
                          << left(12, word_for(achievement.curve->element))
                          << column(8, "{:.0f}", mesh.cells) << " cells"
                          << column(10, "{:.2f}", mesh.cumulative_seconds)
                          << " s"
                          << column(10,
                                    "{:.1f}",
                                    mesh.cumulative_seconds / fastest)
                          << " times the fastest\n";
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
