#include <deal.II/base/timer.h>

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/command/commands.h"
#include "plate_impact/marking/outside_marking.h"
#include "plate_impact/output/console.h"
#include "plate_impact/output/output.h"

#include <algorithm>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    fmt::text_style
    emphasis_of(const Verdict::Part &part)
    {
      return fg(part.trust == Trust::good       ? fmt::terminal_color::green :
                  part.trust == Trust::doubtful ? fmt::terminal_color::yellow :
                                                  fmt::terminal_color::red);
    }



    /// None of an empty text.
    std::string
    line(const std::string &name, const std::string &text)
    {
      return text.empty() ? "" : fmt::format("{:<12}{}\n", name, text);
    }



    /// The name of the scene and the head of the table of cycles.
    std::string
    head_of(const Scene &scene, const PrefixedUnit &time_unit)
    {
      std::string text;
#ifdef DEBUG
      text = "DEBUG build, many times slower; configure with "
             "CMAKE_BUILD_TYPE=Release for results\n";
#endif
      const std::string unit = in_ascii(time_unit.name);
      return text + emphasized(scene.name, fmt::emphasis::bold) +
        "\ncycle  cells unknowns  eta % max xi' peak force N  +- %" +
        right(8, "at " + unit) + right(9, "end " + unit) + " seconds\n";
    }



    std::string
    line_of(const CycleResult &result, const PrefixedUnit &time_unit)
    {
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
          if (const auto end = result.history->last_end_of_impact())
            contact_end = time_unit(*end);
        }
      return column(5, "{:.0f}", result.cycle) +
        column(7, "{:.0f}", result.cells) +
        column(9, "{:.0f}", result.degrees_of_freedom) +
        column(7, "{:.2f}", eta) + column(8, "{:.2f}", xi) +
        column(13, "{:.6g}", peak) + column(6, "{:.2g}", bar) +
        column(8, "{:.4g}", peak_time) + column(9, "{:.5g}", contact_end) +
        column(8, "{:.2f}", result.cumulative_seconds()) + '\n';
    }



    /// What the errors of the last mesh are, behind the outcome.
    std::string
    errors_of(const CycleResult          &last,
              const Outcome               outcome,
              const AdaptivityParameters &adaptivity)
    {
      const bool  for_peak = adaptivity.goal == AdaptationGoal::peak_force;
      std::string text;
      if (for_peak && last.peak_force_bar)
        text = ", peak force to " +
          about_percentage(last.peak_force_bar->total()) + " (target " +
          percentage(adaptivity.target()) + ')';
      else if (last.error)
        text = ", eta " + percentage(last.error->eta) + " (target " +
          percentage(adaptivity.target_error) + ')';
      if (for_peak)
        return text;
      if (last.error && last.error->eta <= adaptivity.target_error &&
          outcome != Outcome::target_reached &&
          last.error_ratios->max_element() >= 1.)
        text += ", largest xi' " + about(last.error_ratios->max_element()) +
          " (limit 1)";
      if (last.cells_at_minimum_size > 0)
        text += " (cells at the minimum size that keep xi' >= 1: " +
          std::to_string(last.cells_at_minimum_size) + ')';
      return text;
    }



    std::string
    end_in_words(const Parameters  &parameters,
                 const Outcome      outcome,
                 const CycleResult &last,
                 const Verdict     &verdict)
    {
      std::string text = '\n' +
        line("Outcome",
             emphasized(word_for(outcome), emphasis_of(verdict.convergence)) +
               errors_of(last, outcome, parameters.adaptivity));
      if (!last.history)
        return text;
      text += line("Peak force",
                   emphasized(in_ascii(verdict.force), fmt::emphasis::bold));
      if (last.verification)
        text += line("Verified",
                     number(last.verification->force) + " N on " +
                       counted(last.verification->n_cells, "cell") + ", " +
                       deviation(last.verification->force,
                                 last.history->peak().force) +
                       " away");
      return text +
        line("Model",
             emphasized(in_ascii(model_in_words(verdict)),
                        emphasis_of(verdict.model))) +
        line("Contact", in_ascii(verdict.warnings.contact)) +
        line("Damage", in_ascii(verdict.warnings.damage)) +
        line("Response",
             "local, of a " + in_ascii(local_response_in_words(parameters)));
    }



    /// For scripts: peak force [N], bar relative to it, outcome, trust.
    std::string
    line_for_scripts(const Outcome      outcome,
                     const CycleResult &last,
                     const Verdict     &verdict)
    {
      std::string text;
      if (last.history)
        text = "peak_force=" + shortest(last.history->peak().force) + " bar=" +
          (last.peak_force_bar ? shortest(last.peak_force_bar->total()) :
                                 "none") +
          " model_error=" +
          (verdict.warnings.model_error() ?
             shortest(*verdict.warnings.model_error()) :
             "none") +
          ' ';
      return text + "outcome=\"" + word_for(outcome) +
        "\" trust=" + word_for(verdict.trust()) +
        " convergence=" + word_for(verdict.convergence.trust) +
        " model=" + word_for(verdict.model.trust) + '\n';
    }



    /// The impact is what counts: without them there is a warning.
    void
    add_frequencies(const unsigned int        n,
                    Cycle                    &cycle,
                    std::vector<std::string> &warnings)
    {
      const dealii::Timer timer;
      try
        {
          cycle.result.natural_frequencies = cycle.plate.natural_frequencies(n);
        }
      catch (const ComputationError &error)
        {
          warnings.push_back("there are no natural frequencies: " +
                             std::string(error.what()));
        }
      cycle.result.seconds.output += timer.wall_time();
    }



    void
    run(const Scene       &scene,
        Output            &output,
        const bool         quiet,
        AdaptationControl &control)
    {
      const Parameters  &parameters = scene.parameters;
      const PrefixedUnit time_unit("s",
                                   std::max(parameters.time.end_time,
                                            100. * parameters.time.time_step));
      Console            console(quiet);
      console.print(head_of(scene, time_unit));
      ImpactAnalysis   analysis(parameters);
      AnalysisListener listener;
      listener.stage = [&](const unsigned int cycle, const std::string &what) {
        throw_if_interrupted();
        console.show(column(5, "{:.0f}", cycle) + "  " + what);
      };
      listener.step =
        [&](const auto cycle, const auto step, const auto n_steps) {
          console.show(column(5, "{:.0f}", cycle) + "  step ", step, n_steps);
        };
      listener.cycle = [&](Cycle &cycle) {
        output.write_cycle(cycle);
        console.print(line_of(cycle.result, time_unit));
      };
      Outcome outcome = analysis.run(control, listener);
      Cycle  &last    = analysis.last_cycle();
      if (parameters.adaptivity.verify)
        analysis.verify();
      if (outcome == Outcome::target_reached && !control.is_met(last.result))
        outcome = Outcome::not_verified;
      auto warnings = analysis.all_warnings();
      add_frequencies(parameters.output.natural_frequencies,
                      last,
                      warnings.numerical);
      const Verdict verdict =
        verdict_of(parameters, outcome, last.result, warnings);
      output.finish(outcome, verdict, last);
      console.print(end_in_words(parameters, outcome, last.result, verdict) +
                    line("Results", output.directory.main_files()));
      if (quiet)
        std::cout << line_for_scripts(outcome, last.result, verdict)
                  << std::flush;
      print_warnings(warnings.all());
    }
  } // namespace



  void
  run_scene(const Scene &scene, const bool quiet, const std::string &marking)
  {
    const AdaptivityParameters &adaptivity = scene.parameters.adaptivity;
    if (!marking.empty() &&
        adaptivity.strategy != AdaptationStrategy::hanging_nodes &&
        adaptivity.strategy != AdaptationStrategy::remeshing)
      throw InputError({"--marking needs Adaptivity/Strategy = hanging nodes "
                        "or remeshing, which give cells the sizes that are "
                        "wanted"});
    Output            output(scene);
    AdaptationControl control(adaptivity);
    control.marking = outside_marking(marking, output.directory);
    try
      {
        run(scene, output, quiet, control);
      }
    catch (const ComputationError &error)
      {
        output.write_failure(error.what());
        throw;
      }
    catch (const Interruption &interruption)
      {
        output.write_failure(interruption.what());
        throw interruption.with(output.kept() + "; a larger " +
                                (adaptivity.is_for_peak_force() ?
                                   "Target peak force error" :
                                   "Target error") +
                                " or a shorter End time makes the run faster");
      }
    catch (const std::bad_alloc &)
      {
        output.write_failure("not enough memory");
        throw;
      }
  }
} // namespace PlateImpact
