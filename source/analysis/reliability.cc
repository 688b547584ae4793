#include "plate_impact/analysis/reliability.h"

#include "plate_impact/analysis/adaptation_control.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/newmark_scheme.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  namespace
  {
    /// The step that the program chose is told as such.
    std::string
    advice_on_step(const TimeParameters &time, const double step)
    {
      return time.step_is_chosen ?
        fmt::format("choose Time/Time step = {} s, or a smaller Time/Step "
                    "tolerance",
                    about(step)) :
        fmt::format("choose at most {} s, or 0", about(step));
    }



    /// What is still to come when the transient ends.
    std::vector<std::string>
    warn_of_end(const Parameters &parameters, const ContactHistory &history)
    {
      const TimeParameters &time = parameters.time;
      const ContactState   &peak = history.peak(),
                         &last   = history.states().back();
      const std::string end      = time.end_is_chosen ?
             "the end of the first contact, " + about(last.time, "s") :
             "Time/End time = " + about(time.end_time) + " s";
      if (peak.time == last.time)
        return {"the force still grows at " + end +
                ": the peak force is that of this time only"};
      if (last.force > 0. && history.n_contacts() > 1)
        return {"another contact is under way at " + end +
                ", and may be harder; choose a later Time/End time"};
      if (last.force > 0.)
        return {"the contact has not ended at " +
                (time.end_is_chosen ?
                   about(last.time, "s") + ", where nobody waits any longer" :
                   end)};
      if (last.impactor_velocity > 0.)
        return {"the impactor still moves towards the plate at " + end +
                ": another contact follows, which may be harder"};
      return {};
    }



    std::vector<std::string>
    warn_of_time(const Parameters  &parameters,
                 const double       expected_contact_time,
                 const CycleResult &result)
    {
      std::vector<std::string> warnings;
      const TimeParameters    &time = parameters.time;
      const ContactState      &peak = result.history->peak(),
                         &last      = result.history->states().back();
      const double rise_time        = peak.force > 0. && peak.time < last.time ?
               result.history->rise_time() :
               std::max(0.5 * expected_contact_time, peak.time);
      // with a goal, the mesh has its share as well
      const AdaptivityParameters &adaptivity  = parameters.adaptivity;
      const bool                  is_for_peak = adaptivity.is_adaptive() &&
        adaptivity.goal == AdaptationGoal::peak_force;
      const double wanted =
        is_for_peak ? 0.3 * adaptivity.target_peak_force_error : 1e-3;
      if (result.time_error &&
          *result.time_error >
            (is_for_peak ? 0.5 * adaptivity.target() : wanted))
        warnings.push_back(fmt::format(
          "Time/Time step = {} s leaves an error of about {} in "
          "the peak force; for {} {}",
          about(time.time_step),
          about_percentage(*result.time_error),
          about_percentage(wanted),
          advice_on_step(time,
                         time.time_step *
                           std::pow(wanted / *result.time_error,
                                    1. / NewmarkScheme(time).order()))));
      // a step that was chosen keeps to the scene's own tolerance
      else if (!result.time_error && !time.step_is_chosen &&
               time.time_step > 0.04 * rise_time)
        warnings.push_back(
          fmt::format("Time/Time step = {} s resolves the rise to the peak "
                      "force, {}, and the waves that the contact sends out, "
                      "coarsely; for a peak force to 0.1 % choose at most "
                      "{} s, or 0",
                      about(time.time_step),
                      about(rise_time, "s"),
                      about(0.04 * rise_time)));
      for (const std::string &end : warn_of_end(parameters, *result.history))
        warnings.push_back(end);
      if (result.sensitivity && result.sensitivity->unpredictable_from)
        warnings.push_back(
          fmt::format("from t = {} on, the force cannot be predicted: a "
                      "velocity larger by a millionth changes it by more "
                      "than 0.1 % of its peak{}",
                      about(*result.sensitivity->unpredictable_from, "s"),
                      peak.time < *result.sensitivity->unpredictable_from ?
                        "; the peak force is known, it comes before" :
                        "; the peak force comes after that"));
      const double drift = result.history->relative_energy_drift();
      if (drift > 1e-3)
        warnings.push_back(
          fmt::format("the total energy changes by {}, by collocation on "
                      "coarse steps or by the damping of Newmark's "
                      "parameters; choose Contact/Integration = energy "
                      "conserving or a smaller step",
                      about_percentage(drift)));
      return warnings;
    }



    /// Of the cells that the waves of the contact reach. [m]
    double
    largest_cell_reached(const Parameters               &parameters,
                         const dealii::Triangulation<2> &mesh,
                         const BendingWave              &wave)
    {
      return cell_sizes_near_load(mesh,
                                  parameters.impactor.contact_half_length(),
                                  wave.group_speed * parameters.time.end_time)
        .second;
    }



    std::vector<std::string>
    warn_of_resolution(const Parameters               &parameters,
                       const dealii::Triangulation<2> &mesh,
                       const BendingWave              &wave,
                       const CycleResult              &result)
    {
      std::vector<std::string> warnings;
      // a spread load excites no waves shorter than itself
      const double length =
        std::max(wave.length, 4. * parameters.contact.patch_radius);
      const double size = largest_cell_reached(parameters, mesh, wave);
      const AdaptivityParameters &adaptivity = parameters.adaptivity;
      const bool for_peak     = adaptivity.goal == AdaptationGoal::peak_force;
      const bool meets_target = for_peak ?
        meets_force_target(result, adaptivity) :
        result.error && result.error->eta <= adaptivity.target();
      if (size > 0.5 * length && !meets_target)
        warnings.push_back(
          fmt::format("cells of {} do not resolve the bending waves of {} "
                      "that the contact sends out while its force rises; "
                      "choose {}",
                      about(size, "m"),
                      about(length, "m"),
                      for_peak || !adaptivity.is_adaptive() ?
                        "cells of at most half of it" :
                        "Adaptivity/Goal = peak force, whose first mesh has "
                        "small cells at the load, and more Maximum cycles"));
      if (for_peak && !meets_target)
        warnings.push_back(fmt::format(
          "the error bar of the peak force is {}: Adaptivity/Target "
          "peak force error, {}, is not met; choose more Maximum "
          "cycles, a smaller Time step or Minimum cell size, or a "
          "larger target",
          result.peak_force_bar ?
            about_percentage(result.peak_force_bar->total()) :
            "not known",
          about_percentage(adaptivity.target())));
      else if (result.error && !meets_target && !adaptivity.is_adaptive())
        warnings.push_back(
          fmt::format("eta is {} on this mesh, more than Adaptivity/Target "
                      "error, {}; choose Adaptivity/Strategy = hanging "
                      "nodes or more Initial cells",
                      about_percentage(result.error->eta),
                      about_percentage(adaptivity.target_error)));
      else if (result.error && !for_peak && meets_target &&
               adaptivity.is_adaptive() &&
               result.cells_above_limit > result.cells_at_minimum_size)
        warnings.push_back(
          fmt::format("eta meets Adaptivity/Target error, but xi' of {} is up "
                      "to {}, wanted below 1; choose more Maximum cycles or a "
                      "smaller Minimum cell size",
                      counted(result.cells_above_limit, "cell"),
                      about(result.over_limit->max_element())));
      else if (result.error && !meets_target)
        warnings.push_back(
          fmt::format("eta is still {}: Adaptivity/Target error, {}, is not "
                      "met; choose more Maximum cycles, a smaller Minimum "
                      "cell size or a larger target",
                      about_percentage(result.error->eta),
                      about_percentage(adaptivity.target_error)));
      return warnings;
    }



    std::vector<std::string>
    warn_of_mesh(const Parameters               &parameters,
                 const dealii::Triangulation<2> &mesh,
                 const BendingWave              &wave,
                 const CycleResult              &result)
    {
      std::vector<std::string> warnings;
      if (result.error && result.error->n_singular_cells > 0)
        warnings.push_back(
          fmt::format("eta leaves out {} nearer to the point load "
                      "than half the thickness, where the exact energy is "
                      "infinite; with them it is {}",
                      counted(result.error->n_singular_cells, "cell"),
                      about_percentage(result.error->eta_of_all_cells)));

      // measured: 0.7 % too stiff with cells 60 times as long as thick, 26 %
      // with cells 600 times
      const double slenderness = largest_cell_reached(parameters, mesh, wave) /
        parameters.plate.thickness;
      if (parameters.discretization.element == ElementType::serendipity &&
          slenderness > 60.)
        warnings.push_back(
          fmt::format("the serendipity element locks in cells as long as {} "
                      "thicknesses; choose Discretization/Element = MITC9 "
                      "or cells below 60 thicknesses",
                      about(slenderness)));
      return warnings;
    }
  } // namespace



  Warnings
  impact_warnings(const Parameters  &parameters,
                  const double       contact_time,
                  const CycleResult &result)
  {
    Warnings   warnings = model_warnings(parameters, result);
    const auto of_time  = warn_of_time(parameters, contact_time, result);
    warnings.numerical.insert(warnings.numerical.begin(),
                              of_time.begin(),
                              of_time.end());
    return warnings;
  }



  Warnings
  reliability_warnings(const Parameters               &parameters,
                       const dealii::Triangulation<2> &mesh,
                       const CycleResult              &result,
                       const ImpactEstimate           &expected)
  {
    const BendingWave &wave = expected.wave;
    Warnings           warnings =
      impact_warnings(parameters, expected.contact_time, result);
    for (const auto &more : {warn_of_resolution(parameters, mesh, wave, result),
                             warn_of_mesh(parameters, mesh, wave, result)})
      warnings.numerical.insert(warnings.numerical.end(),
                                more.begin(),
                                more.end());
    return warnings;
  }
} // namespace PlateImpact
