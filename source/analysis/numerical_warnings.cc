#include "plate_impact/analysis/goal.h"
#include "plate_impact/analysis/time_control.h"
#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/text.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/newmark_scheme.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    std::vector<std::string>
    warn_of_step(const Parameters  &parameters,
                 const CycleResult &result,
                 const double       expected_contact_time)
    {
      const TimeParameters       &time       = parameters.time;
      const AdaptivityParameters &adaptivity = parameters.adaptivity;
      const ContactHistory       &history    = *result.history;
      const ContactState         &peak       = history.peak();
      if (result.time_error)
        {
          // the mesh has its share of a target for the force
          const double error  = *result.time_error,
                       wanted = adaptivity.is_for_peak_force() ?
            share_of_step(result.peak_is_late) *
              adaptivity.target_peak_force_error :
            1e-3;
          if (error <= (adaptivity.is_for_peak_force() ?
                          0.5 * adaptivity.target() :
                          wanted))
            return {};
          const unsigned int order =
            NewmarkScheme(time, parameters.contact.integration).order();
          const std::string step =
            about(time.time_step * std::pow(wanted / error, 1. / order));
          // the step that the program chose is told as such
          return {fmt::format(
            "Time/Time step = {} s leaves an error of about {} in the peak "
            "force; for {} {}",
            about(time.time_step),
            about_percentage(error),
            about_percentage(wanted),
            time.step_is_chosen ? "choose Time/Time step = " + step +
                " s, or a smaller Time/Step tolerance" :
                                  "choose at most " + step + " s, or 0")};
        }
      const double rise =
        peak.force > 0. && peak.time < history.states().back().time ?
        history.rise_time() :
        std::max(0.5 * expected_contact_time, peak.time);
      // a step that was chosen keeps to the scene's own tolerance
      if (time.step_is_chosen || time.time_step <= 0.04 * rise)
        return {};
      return {fmt::format(
        "Time/Time step = {} s resolves only coarsely the rise to the peak "
        "force, {}, and the waves that the contact sends out; for an error of "
        "0.1 % in the peak force choose at most {} s, or 0",
        about(time.time_step),
        about(rise, "s"),
        about(0.04 * rise))};
    }



    /// What is still to come when the transient ends.
    std::vector<std::string>
    warn_of_end(const TimeParameters &time, const ContactHistory &history)
    {
      const ContactState &last = history.states().back();
      const std::string   end  = time.end_is_chosen ?
           "the end of the first contact, " + about(last.time, "s") :
           "Time/End time = " + about(time.end_time) + " s";
      if (history.peak().time == last.time)
        return {"the force still grows at " + end +
                ": the true peak force is larger; choose a later Time/End "
                "time"};
      if (last.force > 0. && history.n_contacts() > 1)
        return {"another contact is under way at " + end +
                "; its force may be larger; choose a later Time/End time"};
      if (last.force > 0.)
        return {"the contact has not ended at " +
                (time.end_is_chosen ? about(last.time, "s") +
                     ", the latest time that is looked at" :
                                      end)};
      if (last.impactor_velocity > 0.)
        return {"the impactor still moves towards the plate at " + end +
                ": another contact follows, and its force may be larger; "
                "choose a later Time/End time"};
      return {};
    }



    std::vector<std::string>
    warn_of_history(const CycleResult &result)
    {
      std::vector<std::string> warnings;
      if (result.sensitivity && result.sensitivity->unpredictable_from)
        {
          const double from = *result.sensitivity->unpredictable_from;
          warnings.push_back(fmt::format(
            "from t = {} on, the force cannot be predicted: one millionth more "
            "velocity changes it by more than 0.1 % of its peak; the peak "
            "force {}",
            about(from, "s"),
            result.history->peak().time < from ? "comes earlier and is not "
                                                 "affected" :
                                                 "comes later"));
        }
      if (const double drift = result.history->relative_energy_drift();
          drift > 1e-3)
        warnings.push_back(fmt::format(
          "the total energy changes by {}, by collocation on coarse steps or "
          "by the damping of Newmark's parameters; choose Contact/Integration "
          "= energy conserving or a smaller step",
          about_percentage(drift)));
      return warnings;
    }



    std::vector<std::string>
    warn_of_resolution(const Parameters  &parameters,
                       const BendingWave &wave,
                       const double       largest_cell,
                       const bool         meets_target)
    {
      // a spread load excites no waves shorter than itself
      const double length =
        std::max(wave.length, 4. * parameters.contact.patch_radius);
      if (largest_cell <= 0.5 * length || meets_target)
        return {};
      const AdaptivityParameters &adaptivity = parameters.adaptivity;
      return {fmt::format(
        "cells of {} do not resolve the bending waves of {} that the contact "
        "sends out while its force rises; choose {}",
        about(largest_cell, "m"),
        about(length, "m"),
        adaptivity.goal == AdaptationGoal::peak_force ||
            !adaptivity.is_adaptive() || parameters.plate.has_large_deflection ?
          "cells of at most half of it" :
          "Adaptivity/Goal = peak force, whose first mesh has small cells at "
          "the load, and more Maximum cycles")};
    }



    std::vector<std::string>
    warn_of_mesh(const Parameters  &parameters,
                 const CycleResult &result,
                 const double       largest_cell)
    {
      std::vector<std::string> warnings;
      if (result.error && result.error->n_singular_cells > 0)
        warnings.push_back(fmt::format(
          "eta {} {} nearer to the point load than half the thickness, where "
          "the exact energy is infinite; {} it is {}",
          result.error->singular_cells_count ? "counts" : "leaves out",
          counted(result.error->n_singular_cells, "cell"),
          result.error->singular_cells_count ? "without them" : "with them",
          about_percentage(result.error->singular_cells_count ?
                             result.error->eta_of_regular_cells :
                             result.error->eta_of_all_cells)));
      // measured: 0.7 % too stiff with cells 60 times as long as thick, 26 %
      // with cells 600 times
      const double slenderness = largest_cell / parameters.plate.thickness;
      if (parameters.discretization.element == ElementType::serendipity &&
          slenderness > 60.)
        warnings.push_back(fmt::format(
          "the serendipity element locks in cells as long as {} thicknesses; "
          "choose Discretization/Element = MITC9 or cells below 60 thicknesses",
          about(slenderness)));
      return warnings;
    }



    std::vector<std::string>
    joined(const std::initializer_list<std::vector<std::string>> lists)
    {
      std::vector<std::string> all;
      for (const auto &list : lists)
        all.insert(all.end(), list.begin(), list.end());
      return all;
    }
  } // namespace



  Warnings
  impact_warnings(const Parameters  &parameters,
                  const CycleResult &result,
                  const ZenerImpact &expected)
  {
    Warnings warnings = model_warnings(parameters, result, expected);
    warnings.numerical =
      joined({warn_of_step(parameters, result, expected.contact_time()),
              warn_of_end(parameters.time, *result.history),
              warn_of_history(result),
              warnings.numerical});
    return warnings;
  }



  Warnings
  reliability_warnings(const Parameters       &parameters,
                       const Triangulation<2> &mesh,
                       const CycleResult      &result,
                       const ZenerImpact      &expected)
  {
    Warnings   warnings = impact_warnings(parameters, result, expected);
    const auto goal     = make_goal(parameters.adaptivity);
    // of the cells that the waves of the contact reach
    const double largest_cell =
      cell_sizes_near_load(mesh,
                           parameters.impactor.contact_half_length(),
                           expected.wave().group_speed *
                             parameters.time.end_time)
        .second;
    warnings.numerical =
      joined({warnings.numerical,
              warn_of_resolution(parameters,
                                 expected.wave(),
                                 largest_cell,
                                 goal->is_met(result)),
              goal->warnings(result),
              warn_of_mesh(parameters, result, largest_cell)});
    return warnings;
  }
} // namespace PlateImpact
