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



    /// A number, or a dash, at the right end of a column of some width.
    std::string
    column(const std::size_t            width,
           const char                  *format,
           const std::optional<double> &value)
    {
      const std::string text = value ? formatted(format, *value) : "-";
      return std::string(width - std::min(width, text.size()), ' ') + text;
    }



    /// A time that someone waits.
    std::string
    waiting_time(const double seconds)
    {
      if (seconds < 100.)
        return formatted("%.0f s", seconds);
      if (seconds < 6000.)
        return formatted("%.0f min", seconds / 60.);
      return formatted("%.1f h", seconds / 3600.);
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
    target = scene.parameters.adaptivity.target_error;
    if (quiet)
      return;
#ifdef DEBUG
    std::cout << "DEBUG build, many times slower; configure with "
                 "CMAKE_BUILD_TYPE=Release for results\n";
#endif
    std::cout << out.emphasized(scene.name, Emphasis::bold) << "\n"
              << "cycle   cells unknowns   eta % max xi' peak force N    at us"
                 "   end us  seconds"
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
        xi  = result.error->max_element_error();
      }
    if (result.history)
      {
        peak      = result.history->peak().force;
        peak_time = 1e6 * result.history->peak().time;
        if (const auto end = result.history->first_contact_end())
          contact_end = 1e6 * *end;
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
        if (last.cells_at_minimum_size > 0)
          std::cout << " (" << last.cells_at_minimum_size
                    << " cells at the minimum size keep xi' >= 1)";
        if (last.history)
          std::cout << "\nPeak force  "
                    << out.emphasized(formatted("%.6g N",
                                                last.history->peak().force),
                                      Emphasis::bold)
                    << " at "
                    << formatted("%.6g us", 1e6 * last.history->peak().time);
        std::cout << "\nResults     " << results << std::endl;
      }
    for (const std::string &warning : warnings)
      std::cerr << err.emphasized("warning: ", Emphasis::warning) << warning
                << std::endl;
  }
} // namespace PlateImpact
