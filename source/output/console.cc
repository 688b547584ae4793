#include "plate_impact/output/console.h"

#include "plate_impact/base/text.h"
#include "plate_impact/output/run_in_words.h"

#include <csignal>
#include <iostream>
#include <unistd.h>

namespace PlateImpact
{
  Console::Console(const bool quiet)
    : progress(quiet)
    , quiet(quiet)
    , out(STDOUT_FILENO)
  {
    std::signal(SIGPIPE, SIG_IGN);
  }



  void
  Console::begin(const Scene &scene)
  {
    local_response = scene.parameters.has_impactor() ?
      local_response_in_words(scene.parameters) :
      "";
    target         = scene.parameters.adaptivity.target_error;
    time_unit      = PrefixedUnit("s", scene.parameters.time.end_time);
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
  Console::cycle(const CycleResult &result)
  {
    if (quiet)
      return;
    progress.clear();
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
    std::cout << column(5, "{:.0f}", result.cycle)
              << column(8, "{:.0f}", result.cells)
              << column(9, "{:.0f}", result.degrees_of_freedom)
              << column(8, "{:.2f}", eta) << column(8, "{:.2f}", xi)
              << column(13, "{:.6g}", peak) << column(9, "{:.4g}", peak_time)
              << column(9, "{:.5g}", contact_end)
              << column(9, "{:.2f}", result.seconds.total()) << std::endl;
  }



  void
  Console::end(const Outcome                   outcome,
               const CycleResult              &last,
               const std::vector<std::string> &warnings,
               const std::string              &results)
  {
    if (!quiet)
      {
        std::cout << "\nOutcome     "
                  << out.emphasized(word_for(outcome),
                                    is_success(outcome) ? Emphasis::good :
                                                          Emphasis::warning);
        if (last.error)
          std::cout << ", eta " << percentage(last.error->eta) << " (target "
                    << percentage(target) << ')';
        if (last.error && last.error->eta <= target &&
            outcome != Outcome::target_reached &&
            last.over_limit->max_element() >= 1.)
          std::cout << ", largest xi' " << about(last.over_limit->max_element())
                    << " (limit 1)";
        if (last.cells_at_minimum_size > 0)
          std::cout << " (cells at the minimum size that keep xi' >= 1: "
                    << last.cells_at_minimum_size << ")";
        if (last.history)
          std::cout << "\nPeak force  "
                    << out.emphasized(number(last.history->peak().force) + " N",
                                      Emphasis::bold)
                    << " at "
                    << in_ascii(time_unit.text(last.history->peak().time));
        if (!local_response.empty())
          std::cout << "\nContact     local response of a "
                    << in_ascii(local_response);
        std::cout << "\nResults     " << results << std::endl;
      }
    print_warnings(warnings);
  }
} // namespace PlateImpact
