#include "plate_impact/console.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <unistd.h>

namespace PlateImpact
{
  namespace
  {
    std::string
    formatted(const char *format, const double value)
    {
      char text[64];
      std::snprintf(text, sizeof(text), format, value);
      return text;
    }



    /// Curves listed for a threshold; comparison.html has all.
    constexpr std::size_t n_listed = 4;



    /// A word at the left end of a column of some width.
    std::string
    padded(const std::size_t width, const std::string &word)
    {
      return word + std::string(width - std::min(width, word.size()), ' ');
    }



    /// In the letters that every terminal has.
    std::string
    in_ascii(std::string unit)
    {
      const std::string micro = "µ";
      if (unit.compare(0, micro.size(), micro) == 0)
        unit.replace(0, micro.size(), "u");
      return unit;
    }



    /// A word at the right end of a column of some width.
    std::string
    right(const std::size_t width, const std::string &word)
    {
      return std::string(width - std::min(width, word.size()), ' ') + word;
    }



    /// A number, or a dash, at the right end of a column of some width.
    std::string
    column(const std::size_t            width,
           const char                  *format,
           const std::optional<double> &value)
    {
      return right(width, value ? formatted(format, *value) : "-");
    }
  } // namespace



  Console::Console(const bool quiet)
    : quiet(quiet)
    , out(STDOUT_FILENO)
    , err(STDERR_FILENO)
  {
    std::signal(SIGPIPE, SIG_IGN);
  }



  Console::~Console()
  {
    clear_progress();
  }



  void
  Console::begin(const Scene &scene)
  {
    target    = scene.parameters.adaptivity.target_error;
    time_unit = PrefixedUnit("s", scene.parameters.time.end_time);
    if (quiet)
      return;
#ifdef DEBUG
    std::cout << "DEBUG build, many times slower; configure with "
                 "CMAKE_BUILD_TYPE=Release for results\n";
#endif
    std::cout << out.emphasized(scene.name, Emphasis::bold) << "\n"
              << "cycle   cells unknowns   eta % max xi' peak force N"
              << right(9, "at " + in_ascii(time_unit.name()))
              << right(9, "end " + in_ascii(time_unit.name())) << "  seconds"
              << std::endl;
  }



  void
  Console::progress(const unsigned int cycle,
                    const unsigned int step,
                    const unsigned int n_steps)
  {
    if (quiet || !out.is_interactive())
      return;
    const Clock::time_point now = Clock::now();
    if (cycle != cycle_in_progress)
      {
        cycle_in_progress  = cycle;
        begin_of_transient = last_progress = now;
      }
    if (now - last_progress < std::chrono::milliseconds(500))
      return;
    last_progress                               = now;
    has_progress                                = true;
    const std::chrono::duration<double> elapsed = now - begin_of_transient;
    std::cout << "\r\033[K" << column(5, "%.0f", cycle) << "  step " << step
              << " of " << n_steps << ", "
              << waiting_time(elapsed.count() * (n_steps - step) / step)
              << " left" << std::flush;
  }



  void
  Console::clear_progress()
  {
    if (has_progress)
      std::cout << "\r\033[K";
    has_progress = false;
  }



  void
  Console::cycle(const CycleResult &result)
  {
    if (quiet)
      return;
    clear_progress();
    std::optional<double> eta, xi, peak, peak_time, contact_end;
    if (result.error)
      {
        eta = 100. * result.error->eta;
        xi  = result.over_limit->max_element();
      }
    if (result.history)
      {
        peak      = result.history->peak().force;
        peak_time = time_unit(result.history->peak().time);
        if (const auto end = result.history->first_contact_end())
          contact_end = time_unit(*end);
      }
    std::cout << column(5, "%.0f", result.cycle)
              << column(8, "%.0f", result.cells)
              << column(9, "%.0f", result.degrees_of_freedom)
              << column(8, "%.2f", eta) << column(8, "%.2f", xi)
              << column(13, "%.6g", peak) << column(9, "%.4g", peak_time)
              << column(9, "%.5g", contact_end)
              << column(9, "%.2f", result.seconds.total()) << std::endl;
  }



  void
  Console::end(const std::string              &outcome,
               const CycleResult              &last,
               const std::vector<std::string> &warnings,
               const std::string              &results)
  {
    if (!quiet)
      {
        std::cout << "\nOutcome     "
                  << out.emphasized(outcome,
                                    outcome == "target reached" ||
                                        outcome == "single mesh" ?
                                      Emphasis::good :
                                      Emphasis::warning);
        if (last.error)
          std::cout << ", eta " << formatted("%.6g", 100. * last.error->eta)
                    << " % (target " << formatted("%.6g", 100. * target)
                    << " %)";
        if (last.error && last.error->eta <= target &&
            outcome != "target reached" && last.over_limit->max_element() >= 1.)
          std::cout << ", largest xi' "
                    << formatted("%.3g", last.over_limit->max_element())
                    << " (limit 1)";
        if (last.cells_at_minimum_size > 0)
          std::cout << " (cells at the minimum size that keep xi' >= 1: "
                    << last.cells_at_minimum_size << ")";
        if (last.history)
          std::cout << "\nPeak force  "
                    << out.emphasized(formatted("%.6g N",
                                                last.history->peak().force),
                                      Emphasis::bold)
                    << " at "
                    << formatted("%.6g ", time_unit(last.history->peak().time))
                    << in_ascii(time_unit.name());
        std::cout << "\nResults     " << results << std::endl;
      }
    warn(warnings);
  }



  void
  Console::warn(const std::vector<std::string> &warnings) const
  {
    for (const std::string &warning : warnings)
      std::cerr << err.emphasized("warning: ", Emphasis::warning) << warning
                << std::endl;
  }



  void
  Console::begin_comparison(const Scene &scene)
  {
    if (!quiet)
      std::cout << out.emphasized(scene.name, Emphasis::bold)
                << "\nComputing the reference" << std::endl;
  }



  void
  Console::reference(const Reference &reference)
  {
    if (quiet)
      return;
    clear_progress();
    std::cout << "Reference   " << formatted("%.6g", reference.peak_force)
              << " N";
    if (reference.history)
      std::cout << ", uncertain by "
                << formatted("%.2g", 100. * reference.uncertainty)
                << " %: " << reference.cells
                << " cells, eta = " << formatted("%.2g", 100. * *reference.eta)
                << " %, " << formatted("%.2f", reference.seconds) << " s";
    else
      std::cout << ", given";
    std::cout
      << "\n\n strategy        element       cycle      cells   unknowns"
         "     eta %  peak force N   error %   seconds    so far"
      << std::endl;
  }



  void
  Console::compared_mesh(const ComparisonCurve &curve)
  {
    if (quiet)
      return;
    clear_progress();
    const ComparedMesh &mesh = curve.meshes.back();
    std::cout << ' ' << padded(16, curve.strategy) << padded(12, curve.element)
              << column(7, "%.0f", mesh.cycle) << column(11, "%.0f", mesh.cells)
              << column(11, "%.0f", mesh.degrees_of_freedom)
              << column(10, "%.2f", 100. * mesh.eta)
              << column(14, "%.6g", mesh.peak_force)
              << column(10,
                        mesh.is_comparable ? "%.4f" : "(%.4f)",
                        100. * mesh.peak_force_error)
              << column(10, "%.2f", mesh.seconds)
              << column(10, "%.2f", mesh.cumulative_seconds) << std::endl;
  }



  void
  Console::curve_end(const ComparisonCurve &curve)
  {
    if (quiet)
      return;
    clear_progress();
    std::cout << " " << std::string(16, ' ') << curve.end << std::endl;
  }



  void
  Console::end_comparison(const std::vector<ThresholdRow> &rows,
                          const std::vector<std::string>  &warnings,
                          const std::string               &results)
  {
    if (!quiet)
      {
        for (const ThresholdRow &row : rows)
          {
            std::cout << "\n"
                      << row.quantity << " of "
                      << formatted("%g", 100. * row.threshold) << " %\n";
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
                std::cout << ' ' << padded(16, achievement.curve->strategy)
                          << padded(12, achievement.curve->element)
                          << column(8, "%.0f", mesh.cells) << " cells"
                          << column(10, "%.2f", mesh.cumulative_seconds) << " s"
                          << column(10,
                                    "%.1f",
                                    mesh.cumulative_seconds / fastest)
                          << " times the fastest\n";
              }
            if (row.achievements.size() > n_listed)
              std::cout << " and " << row.achievements.size() - n_listed
                        << " more\n";
          }
        std::cout << "\nResults     " << results << std::endl;
      }
    warn(warnings);
  }
} // namespace PlateImpact
