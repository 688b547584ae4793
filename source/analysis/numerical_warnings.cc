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
    using Sentences = std::vector<std::string>;

    void
    warn_of_step(const ComputedImpact &impact, Sentences &warnings)
    {
      const TimeParameters       &time       = impact.parameters.time;
      const AdaptivityParameters &adaptivity = impact.parameters.adaptivity;
      if (impact.result.time_error)
        {
          // the mesh has its share of a target for the force
          const double error  = *impact.result.time_error,
                       wanted = adaptivity.is_for_peak_force() ?
            share_of_step(impact.result.peak_is_late) *
              adaptivity.target_peak_force_error :
            1e-3;
          if (error <= (adaptivity.is_for_peak_force() ?
                          0.5 * adaptivity.target() :
                          wanted))
            return;
          const unsigned int order =
            NewmarkScheme(time, impact.contact.integration).order();
          const std::string step =
            about(time.time_step * std::pow(wanted / error, 1. / order));
          // the step that the program chose is told as such
          return warnings.push_back(fmt::format(
            "Time/Time step = {} s leaves an error of about {} in the peak "
            "force; for {} {}",
            about(time.time_step),
            about_percentage(error),
            about_percentage(wanted),
            time.step_is_chosen ? "choose Time/Time step = " + step +
                " s, or a smaller Time/Step tolerance" :
                                  "choose at most " + step + " s, or 0"));
        }
      const double rise =
        impact.peak.force > 0. && impact.peak.time < impact.last.time ?
        impact.history.rise_time() :
        std::max(0.5 * impact.expected.contact_time(), impact.peak.time);
      // a step that was chosen keeps to the scene's own tolerance
      if (!time.step_is_chosen && time.time_step > 0.04 * rise)
        warnings.push_back(fmt::format(
          "Time/Time step = {} s resolves the rise to the peak force, {}, and "
          "the waves that the contact sends out only coarsely; choose at most "
          "{} s for an error of 0.1 % in the peak force, or 0",
          about(time.time_step),
          about(rise, "s"),
          about(0.04 * rise)));
    }



    /// What is still to come when the transient ends.
    void
    warn_of_end(const ComputedImpact &impact, Sentences &warnings)
    {
      const TimeParameters &time        = impact.parameters.time;
      const ContactState   &last        = impact.last;
      const auto            contact_end = impact.history.first_contact_end();
      const std::string     end         = !time.end_is_chosen ?
                    "Time/End time = " + about(time.end_time) + " s" :
                    contact_end && *contact_end > 0.98 * last.time ?
                    "the end of the first contact, " + about(last.time, "s") :
                    about(last.time, "s") + ", the last time computed";
      if (impact.peak.time == last.time)
        warnings.push_back("the force still grows at " + end +
                           ": the true peak force is larger; choose a later "
                           "Time/End time");
      else if (last.force > 0. && impact.history.n_contacts() > 1)
        warnings.push_back("another contact is under way at " + end +
                           "; its force may be larger; choose a later Time/End "
                           "time");
      else if (last.force > 0.)
        warnings.push_back("the contact has not ended at " + end);
      else if (last.impactor_velocity > 0.)
        warnings.push_back("the impactor still moves towards the plate at " +
                           end +
                           ": another contact follows, and its force may be "
                           "larger; choose a later Time/End time");
    }



    void
    warn_of_history(const ComputedImpact &impact, Sentences &warnings)
    {
      const auto &sensitivity = impact.result.sensitivity;
      if (sensitivity && sensitivity->unpredictable_from)
        {
          const double from = *sensitivity->unpredictable_from;
          warnings.push_back(fmt::format(
            "from t = {} on, the force cannot be predicted: a velocity "
            "larger by one millionth changes it by more than 0.1 % of its peak; "
            "the peak force {}",
            about(from, "s"),
            impact.peak.time < from ? "comes earlier and is not affected" :
                                      "comes later"));
        }
      if (const double drift = impact.history.relative_energy_drift();
          drift > 1e-3)
        warnings.push_back(fmt::format(
          "the total energy changes by {}, by collocation on coarse steps or "
          "by the damping of Newmark's parameters; choose Contact/Integration "
          "= energy conserving or a smaller step",
          about_percentage(drift)));
    }



    void
    warn_of_resolution(const ComputedImpact &impact,
                       const double          largest_cell,
                       Sentences            &warnings)
    {
      // a spread load excites no waves shorter than itself
      const double length = std::max(impact.expected.wave().length,
                                     4. * impact.contact.patch_radius);
      if (largest_cell <= 0.5 * length)
        return;
      const AdaptivityParameters &adaptivity = impact.parameters.adaptivity;
      warnings.push_back(fmt::format(
        "cells of {} do not resolve the bending waves of {} that the contact "
        "sends out while its force rises; choose {}",
        about(largest_cell, "m"),
        about(length, "m"),
        adaptivity.goal == AdaptationGoal::peak_force ||
            !adaptivity.is_adaptive() || impact.plate.has_large_deflection ?
          "cells of at most half this wavelength" :
          "Adaptivity/Goal = peak force, whose first mesh has small cells at "
          "the load, and more Maximum cycles"));
    }



    void
    warn_of_mesh(const ComputedImpact &impact,
                 const double          largest_cell,
                 Sentences            &warnings)
    {
      const auto &error = impact.result.error;
      if (error && error->n_singular_cells > 0)
        warnings.push_back(fmt::format(
          "eta {} {} within half the thickness of the point load, where the "
          "exact energy is infinite; {} eta is {}",
          error->singular_cells_count ? "counts" : "leaves out",
          counted(error->n_singular_cells, "cell"),
          error->singular_cells_count ? "without these cells" :
                                        "with these cells",
          about_percentage(error->singular_cells_count ?
                             error->eta_of_regular_cells :
                             error->eta_of_all_cells)));
      // measured: 0.7 % too stiff with cells 60 times as long as thick, 26 %
      // with cells 600 times
      const double slenderness = largest_cell / impact.plate.thickness;
      if (impact.parameters.discretization.element ==
            ElementType::serendipity &&
          slenderness > 60.)
        warnings.push_back(fmt::format(
          "the serendipity element locks in cells as long as {} thicknesses; "
          "choose Discretization/Element = MITC9 or cells below 60 thicknesses",
          about(slenderness)));
    }
  } // namespace



  Warnings
  impact_warnings(const ComputedImpact &impact, const Triangulation<2> *mesh)
  {
    Sentences of_time;
    warn_of_step(impact, of_time);
    warn_of_end(impact, of_time);
    warn_of_history(impact, of_time);
    Warnings warnings = model_warnings(impact);
    warnings.numerical.insert(warnings.numerical.begin(),
                              of_time.begin(),
                              of_time.end());
    if (mesh == nullptr)
      return warnings;
    const Goal goal(impact.parameters.adaptivity);
    // of the cells that the waves of the contact reach
    const double largest_cell =
      cell_sizes_near_load(*mesh,
                           impact.impactor.contact_half_length(),
                           impact.expected.wave().group_speed *
                             impact.parameters.time.end_time)
        .second;
    if (!goal.is_met(impact.result))
      warn_of_resolution(impact, largest_cell, warnings.numerical);
    if (const auto warning = goal.warning(impact.result); !warning.empty())
      warnings.numerical.push_back(warning);
    warn_of_mesh(impact, largest_cell, warnings.numerical);
    return warnings;
  }
} // namespace PlateImpact
