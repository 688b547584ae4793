#include "plate_impact/analysis/goal.h"
#include "plate_impact/analysis/time_control.h"
#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/text.h"
#include "plate_impact/plate/plate_mesh.h"

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Where end time, time step and mesh leave the peak force open.
    class NumericalLimits : ComputedImpact
    {
    public:
      NumericalLimits(const ComputedImpact   &impact,
                      const Triangulation<2> *mesh)
        : ComputedImpact(impact)
      {
        check_step();
        check_end();
        check_history();
        warnings = model_warnings(impact, warnings);
        if (mesh != nullptr)
          check_mesh(*mesh);
      }

      Warnings warnings;

    private:
      /// Notes a sentence, with {} for each number.
      template <typename... Numbers>
      void
      warn(const char *sentence, const Numbers &...numbers)
      {
        warnings.numerical.push_back(fmt::format(sentence, numbers...));
      }

      void
      check_step()
      {
        if (result.time_error)
          {
            const double error = *result.time_error;
            // the mesh has its share of a target for the force
            const auto [most, wanted] = adaptivity.is_for_peak_force() ?
              std::pair(0.5 * adaptivity.target(),
                        share_of_step * adaptivity.target()) :
              std::pair(1e-3, 1e-3);
            if (error <= most)
              return;
            const unsigned int order =
              NewmarkScheme(time, contact.integration).order;
            const std::string step =
              about(time.time_step * std::pow(wanted / error, 1. / order));
            // the step that the program chose is told as such
            return warn(
              "Time/Time step = {} s leaves an error of about {} in the peak "
              "force; for {} {}",
              about(time.time_step),
              about_percentage(error),
              about_percentage(wanted),
              time.step_is_chosen ? "choose Time/Time step = " + step +
                  " s, or a smaller Time/Step tolerance" :
                                    "choose at most " + step + " s, or 0");
          }
        const double rise = peak.force > 0. && peak.time < last.time ?
          history.rise_time() :
          std::max(0.5 * expected.contact_time(), peak.time);
        // a step that was chosen keeps to the scene's own tolerance
        if (!time.step_is_chosen && time.time_step > 0.04 * rise)
          warn("Time/Time step = {} s resolves the rise to the peak force, {}, "
               "and the waves that the contact sends out only coarsely; choose "
               "at most {} s for an error of 0.1 % in the peak force, or 0",
               about(time.time_step),
               about(rise, "s"),
               about(0.04 * rise));
      }

      /// What is still to come when the transient ends.
      void
      check_end()
      {
        const auto        contact_end = history.end_of_impact();
        const std::string end         = !time.end_is_chosen ?
                  "Time/End time = " + about(time.end_time) + " s" :
                  contact_end && *contact_end > 0.98 * last.time ?
                  "the end of the first contact, " + about(last.time, "s") :
                  about(last.time, "s") + ", the last time computed";
        if (peak.time == last.time)
          warn("the force still grows at {}: the true peak force is larger; "
               "choose a later Time/End time",
               end);
        else if (last.force > 0. && history.n_contacts() > 1)
          warn("another contact is under way at {}; its force may be larger; "
               "choose a later Time/End time",
               end);
        else if (last.force > 0.)
          warn("the contact has not ended at {}", end);
        else if (last.impactor_velocity > 0.)
          warn("the impactor still moves towards the plate at {}: another "
               "contact follows, and its force may be larger; choose a later "
               "Time/End time",
               end);
      }

      void
      check_history()
      {
        if (result.sensitivity && result.sensitivity->unpredictable_from)
          {
            const double from = *result.sensitivity->unpredictable_from;
            warn("from t = {} on, the force cannot be predicted: a velocity "
                 "larger by one millionth changes it by more than 0.1 % of its "
                 "peak; the peak force {}",
                 about(from, "s"),
                 peak.time < from ? "comes earlier and is not affected" :
                                    "comes later");
          }
        if (const double drift = history.relative_energy_drift(); drift > 1e-3)
          warn("the total energy changes by {}, by collocation on coarse steps "
               "or by the damping of Newmark's parameters; choose "
               "Contact/Integration = energy conserving or a smaller step",
               about_percentage(drift));
      }

      void
      check_mesh(const Triangulation<2> &mesh)
      {
        const AdaptationControl goal(adaptivity);
        // of the cells that the waves of the contact reach
        const double largest_cell =
          cell_sizes_near_load(mesh,
                               impactor.contact_half_length(),
                               expected.wave().group_speed * time.end_time)
            .second;
        // a spread load excites no waves shorter than itself
        const double length =
          std::max(expected.wave().length, 4. * contact.patch_radius);
        if (!goal.is_met(result) && largest_cell > 0.5 * length)
          warn("cells of {} do not resolve the bending waves of {} that the "
               "contact sends out while its force rises; choose {}",
               about(largest_cell, "m"),
               about(length, "m"),
               adaptivity.goal == AdaptationGoal::peak_force ||
                   !adaptivity.is_adaptive() || plate.has_large_deflection ?
                 "cells of at most half this wavelength" :
                 "Adaptivity/Goal = peak force, whose first mesh has small "
                 "cells at the load, and more Maximum cycles");
        if (const auto warning = goal.warning(result); !warning.empty())
          warnings.numerical.push_back(warning);
        const auto &error = result.error;
        if (error && error->n_singular_cells > 0)
          warn("eta {} {} within half the thickness of the point load, where "
               "the exact energy is infinite; {} eta is {}",
               error->singular_cells_count ? "counts" : "leaves out",
               counted(error->n_singular_cells, "cell"),
               error->singular_cells_count ? "without these cells" :
                                             "with these cells",
               about_percentage(error->singular_cells_count ?
                                  error->eta_of_regular_cells :
                                  error->eta_of_all_cells));
        // measured: 0.7 % too stiff with cells 60 times as long as thick, 26 %
        // with cells 600 times
        const double slenderness = largest_cell / plate.thickness;
        if (parameters.discretization.element == ElementType::serendipity &&
            slenderness > 60.)
          warn("the serendipity element locks in cells as long as {} "
               "thicknesses; choose Discretization/Element = MITC9 or cells "
               "below 60 thicknesses",
               about(slenderness));
      }
    };
  } // namespace



  Warnings
  impact_warnings(const ComputedImpact &impact, const Triangulation<2> *mesh)
  {
    return NumericalLimits(impact, mesh).warnings;
  }
} // namespace PlateImpact
