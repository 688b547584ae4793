#include "plate_impact/console.h"

#include <cstdio>
#include <iostream>
#include <unistd.h>

namespace PlateImpact
{
  namespace
  {
    /// A number in a column, or a dash.
    std::string
    column(const char *format, const std::optional<double> &value)
    {
      char text[64];
      if (value)
        std::snprintf(text, sizeof(text), format, *value);
      const std::string number = value ? text : "-";
      return number.size() < 11 ? std::string(11 - number.size(), ' ') + number
                                : number;
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
    std::cout << scene.name << '\n'
              << " cycle      cells   unknowns      eta %    max xi'   peak "
                 "force    at time  contact end    seconds\n"
              << "                                                            "
                 "N         us           us\n";
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
    std::cout << column("%.0f", result.cycle).substr(5)
              << column("%.0f", result.cells)
              << column("%.0f", result.degrees_of_freedom)
              << column("%.2f", eta) << column("%.2f", xi)
              << column("%.6g", peak) << ' '
              << column("%.4g", peak_time).substr(1) << "  "
              << column("%.5g", contact_end)
              << column("%.2f", result.seconds.total()) << std::endl;
  }



  void
  Console::end(const std::string              &outcome,
               const CycleResult              &last,
               const std::vector<std::string> &warnings,
               const std::string              &files)
  {
    for (const std::string &warning : warnings)
      std::cerr << "warning: " << warning << '\n';
    if (quiet)
      return;
    std::cout << "\nOutcome:    " << outcome;
    if (last.cells_at_minimum_size > 0)
      std::cout << " (" << last.cells_at_minimum_size
                << " cells at the minimum size keep xi' >= 1)";
    if (last.history)
      std::printf("\nPeak force: %.6g N at %.4g us",
                  last.history->peak().force,
                  1e6 * last.history->peak().time);
    std::fflush(stdout);
    std::cout << "\nFiles:      " << files << std::endl;
  }
} // namespace PlateImpact
