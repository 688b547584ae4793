#include "plate_impact/output/console.h"

#include "plate_impact/base/text.h"
#include "plate_impact/output/run_in_words.h"

#include <csignal>
#include <iostream>
#include <unistd.h>

namespace PlateImpact
{
  namespace
  {
    Emphasis
    emphasis_of(const Verdict::Part &part)
    {
      return part.trust == Trust::good ? Emphasis::good :
        part.trust == Trust::doubtful  ? Emphasis::warning :
                                         Emphasis::error;
    }
  } // namespace



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
    adaptivity     = scene.parameters.adaptivity;
    time_unit      = PrefixedUnit("s",
                             std::max(scene.parameters.time.end_time,
                                      100. * scene.parameters.time.time_step));
    if (quiet)
      return;
#ifdef DEBUG
    std::cout << "DEBUG build, many times slower; configure with "
                 "CMAKE_BUILD_TYPE=Release for results\n";
#endif
    std::cout << out.emphasized(scene.name, Emphasis::bold) << "\n"
              << "cycle  cells unknowns  eta % max xi' peak force N  +- %"
              << right(8, "at " + in_ascii(time_unit.name()))
              << right(9, "end " + in_ascii(time_unit.name())) << " seconds"
              << std::endl;
  }



  void
  Console::cycle(const CycleResult &result)
  {
    if (quiet)
      return;
    progress.clear();
    std::optional<double> eta, xi, peak, bar, peak_time, contact_end;
    if (result.error)
      {
        eta = 100. * result.error->eta;
        xi  = result.error_ratios->max_element();
      }
    if (result.history)
      {
        peak = result.history->peak().force;
        if (result.peak_force_bar)
          bar = 100. * result.peak_force_bar->total();
        peak_time = time_unit(result.history->peak().time);
        if (const auto end = result.history->first_contact_end())
          contact_end = time_unit(*end);
      }
    std::cout << column(5, "{:.0f}", result.cycle)
              << column(7, "{:.0f}", result.cells)
              << column(9, "{:.0f}", result.degrees_of_freedom)
              << column(7, "{:.2f}", eta) << column(8, "{:.2f}", xi)
              << column(13, "{:.6g}", peak) << column(6, "{:.2g}", bar)
              << column(8, "{:.4g}", peak_time)
              << column(9, "{:.5g}", contact_end)
              << column(8, "{:.2f}", result.cumulative_seconds()) << std::endl;
  }



  void
  Console::print_line(const Outcome      outcome,
                      const CycleResult &last,
                      const Verdict     &verdict) const
  {
    if (last.history)
      std::cout << "peak_force=" << shortest(last.history->peak().force)
                << " bar="
                << (last.peak_force_bar ?
                      shortest(last.peak_force_bar->total()) :
                      "none")
                << ' ';
    std::cout << "outcome=\"" << word_for(outcome)
              << "\" trust=" << word_for(verdict.trust())
              << " convergence=" << word_for(verdict.convergence.trust)
              << " model=" << word_for(verdict.model.trust) << std::endl;
  }



  void
  Console::end(const Outcome                   outcome,
               const CycleResult              &last,
               const Verdict                  &verdict,
               const std::vector<std::string> &warnings,
               const std::string              &results)
  {
    if (quiet)
      print_line(outcome, last, verdict);
    else
      {
        std::cout << "\nOutcome     "
                  << out.emphasized(word_for(outcome),
                                    emphasis_of(verdict.convergence));
        const bool for_peak = adaptivity.goal == AdaptationGoal::peak_force;
        if (for_peak && last.peak_force_bar)
          std::cout << ", peak force to "
                    << about_percentage(last.peak_force_bar->total())
                    << " (target " << percentage(adaptivity.target()) << ')';
        else if (last.error)
          std::cout << ", eta " << percentage(last.error->eta) << " (target "
                    << percentage(adaptivity.target_error) << ')';
        if (!for_peak && last.error &&
            last.error->eta <= adaptivity.target_error &&
            outcome != Outcome::target_reached &&
            last.error_ratios->max_element() >= 1.)
          std::cout << ", largest xi' "
                    << about(last.error_ratios->max_element()) << " (limit 1)";
        if (!for_peak && last.cells_at_minimum_size > 0)
          std::cout << " (cells at the minimum size that keep xi' >= 1: "
                    << last.cells_at_minimum_size << ")";
        if (last.history)
          std::cout << "\nPeak force  "
                    << out.emphasized(
                         in_ascii(with_error(last.history->peak().force,
                                             last.peak_force_bar ?
                                               last.peak_force_bar->total() *
                                                 last.history->peak().force :
                                               0.,
                                             "N")),
                         Emphasis::bold)
                    << " at "
                    << in_ascii(time_unit.text(last.history->peak().time))
                    << (verdict.convergence.trust == Trust::none &&
                            !last.peak_force_bar ?
                          " (error not known)" :
                          "");
        if (last.verification)
          {
            const double force = last.verification->peak_force;
            std::cout << "\nVerified    " << number(force) << " N on "
                      << counted(last.verification->cells, "cell") << ", "
                      << deviation(force, last.history->peak().force)
                      << " away";
          }
        if (verdict.model.trust != Trust::good)
          std::cout << "\nModel       "
                    << out.emphasized(verdict.model.trust == Trust::none ?
                                        "far outside" :
                                        "outside",
                                      emphasis_of(verdict.model))
                    << ", see "
                    << counted(verdict.model.reasons.size(), "warning");
        if (!local_response.empty())
          std::cout << "\nContact     local response of a "
                    << in_ascii(local_response);
        std::cout << "\nResults     " << results << std::endl;
      }
    print_warnings(warnings);
  }
} // namespace PlateImpact
