#include "plate_impact/console.h"

#include <algorithm>
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



    /// A number, or a dash, at the right end of a column of some width.
    std::string
    column(const std::size_t            width,
           const char                  *format,
           const std::optional<double> &value)
    {
      const std::string text = value ? formatted(format, *value) : "-";
      return std::string(width - std::min(width, text.size()), ' ') + text;
    }
  } // namespace



  Console::Console(const bool quiet)
    : quiet(quiet)
    , shows_progress(!quiet && isatty(STDOUT_FILENO))
    , last_progress(std::chrono::steady_clock::now())
  {}



  void
  Console::begin(const Scene &scene)
  {
    if (quiet)
      return;
#ifdef DEBUG
    std::cout << "DEBUG build, many times slower; configure with "
                 "CMAKE_BUILD_TYPE=Release for results\n";
#endif
    std::cout << scene.name << "\n"
              << " cycle      cells   unknowns      eta %    max xi'"
                 " peak force N      at us  contact end    seconds\n";
  }



  void
  Console::progress(const unsigned int cycle,
                    const unsigned int step,
                    const unsigned int n_steps)
  {
    if (!shows_progress || step % 16 != 0)
      return;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_progress < std::chrono::milliseconds(500))
      return;
    last_progress = now;
    has_progress  = true;
    std::cout << "\r\033[K cycle " << cycle << ": step " << step << " of "
              << n_steps << std::flush;
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
        xi  = result.error->max_element_error();
      }
    if (result.history)
      {
        peak      = result.history->peak().force;
        peak_time = 1e6 * result.history->peak().time;
        if (const auto end = result.history->first_contact_end())
          contact_end = 1e6 * *end;
      }
    std::cout << column(6, "%.0f", result.cycle)
              << column(11, "%.0f", result.cells)
              << column(11, "%.0f", result.degrees_of_freedom)
              << column(11, "%.2f", eta) << column(11, "%.2f", xi)
              << column(13, "%.6g", peak) << column(11, "%.4g", peak_time)
              << column(13, "%.5g", contact_end)
              << column(11, "%.2f", result.seconds.total()) << std::endl;
  }



  void
  Console::end(const std::string              &outcome,
               const CycleResult              &last,
               const std::vector<std::string> &warnings,
               const std::string              &results)
  {
    if (!quiet)
      {
        std::cout << "\nOutcome     " << outcome;
        if (last.cells_at_minimum_size > 0)
          std::cout << " (" << last.cells_at_minimum_size
                    << " cells at the minimum size keep xi' >= 1)";
        if (last.history)
          std::cout << "\nPeak force  "
                    << formatted("%.6g", last.history->peak().force) << " N at "
                    << formatted("%.4g", 1e6 * last.history->peak().time)
                    << " us";
        std::cout << "\nResults     " << results << std::endl;
      }
    for (const std::string &warning : warnings)
      std::cerr << "warning: " << warning << std::endl;
  }
} // namespace PlateImpact
