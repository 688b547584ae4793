#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/command/commands.h"
#include "plate_impact/command/expectation.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/sweep/sweep_computation.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  namespace
  {
    using fmt::format;



    /// Why points that could share a load with its response do not; empty when
    /// they do.
    std::string
    what_keeps_loads_apart(const Parameters &given, const SweepPlan &plan)
    {
      if (given.sweep.estimate_error)
        return "Sweep/Estimate error = true steps every impact by itself";
      if (given.contact.local_response == LocalResponse::half_space &&
          given.contact.has_patch() && given.contact.patch_radius == 0. &&
          !plan.sweeps("Contact/Patch radius"))
        return "Contact/Patch radius = 0 gives each impactor a radius of its "
               "own";
      if (given.time.time_step == 0. && !plan.sweeps("Time/Time step"))
        return "Time/Time step = 0 gives each impactor a step of its own";
      return {};
    }



    /// What is printed: nothing is said of a scene that fails.
    class ExpectationText
    {
    public:
      explicit ExpectationText(const Scene &scene)
        : text(scene.name + " is a valid scene.\n")
        , scene(scene)
      {
        if (!parameters.has_impactor())
          {
            text += "There is no impactor: the plate stays at rest.\n"
                    "\nExpected\n";
            add_frequencies();
            return;
          }
        expected.emplace(parameters);
        text += "\nExpected\n";
        add_impact();
        add_waves();
        add_frequencies();
        text += "\nAdvice\n";
        add_advice();
        add_sweep();
        for (const std::string &warning : expected->warnings)
          text += "  warning: " + in_ascii(warning) + '\n';
      }

      std::string text;

    private:
      void
      line(const std::string &name, const std::string &sentence)
      {
        text += format("  {:<22}{}\n", name, in_ascii(sentence));
      }

      void
      add_impact()
      {
        const ContactState &peak = expected->history.peak();
        if (expected->is_bound)
          {
            line("peak force",
                 format("above {}, {}",
                        about(peak.force, "N"),
                        expected->source));
            line("contact time", "cannot be estimated for this plate");
          }
        else
          {
            line("peak force",
                 format("about {} at {}, {}",
                        about(peak.force, "N"),
                        about(peak.time, "s"),
                        expected->source));
            line("contact time",
                 (expected->contact_end ? "about " : "more than ") +
                   about(expected->contact_end.value_or(expected->until), "s"));
            line("indentation",
                 format("about {}; deflection of the plate under the load {}",
                        about(peak.indentation, "m"),
                        about(expected->history.max_plate_displacement(),
                              "m")));
          }
        line("infinite plate",
             format("{} at {}, by Zener's equation{}",
                    about(expected->zener.peak.force, "N"),
                    about(expected->zener.peak.time, "s"),
                    parameters.impactor.is_cylinder() ?
                      ", for contact at a point" :
                      ""));
        const ContactState rigid = expected->zener.peak_on_rigid_plate();
        line("half-space",
             format("{} at {}, on a plate that does not move: the upper "
                    "bound of a single contact",
                    about(rigid.force, "N"),
                    about(rigid.time, "s")));
        if (!expected->contact.empty())
          line("contact", expected->contact);
        if (parameters.contact.patch_radius > 0.)
          line("load",
               word_for(parameters.contact.load_distribution) + " of " +
                 about(parameters.contact.patch_radius, "m"));
      }

      void
      add_waves()
      {
        const double speed = expected->zener.section.fastest_wave();
        const double back  = 2. * distance_to_edge(parameters) / speed;
        line("first reflection",
             format("back at {}; until then the supports have no effect",
                    about(back, "s")));
        if (const auto n = expected->crossings_before_peak(parameters))
          line("peak",
               format("late: the fastest waves cross the plate {} times "
                      "before, and a small error takes many cells",
                      rounded(std::floor(*n), 3)));

        // the first are those that the warnings of a run speak of
        const double      wavelength = expected->zener.wave().length;
        const double      h          = initial_cell_size(parameters);
        const std::string of_contact = expected->contact_end ?
          format(" and {} of the whole contact",
                 about(expected->zener.wave_of(*expected->contact_end).length,
                       "m")) :
          "";
        line("bending wavelength",
             format("{} as the force rises{}; initial cells of {}{}",
                    about(wavelength, "m"),
                    of_contact,
                    about(h, "m"),
                    h > 0.5 * wavelength ?
                      " do not resolve it: more than one cycle is needed" :
                      ""));
      }

      void
      add_frequencies()
      try
        {
          const std::vector<double> frequencies =
            expected_frequencies(parameters);
          const double highest = frequencies.empty() ? 0. : frequencies.back();
          const PrefixedUnit       unit("Hz", highest);
          std::vector<std::string> values;
          for (const double frequency : frequencies)
            values.push_back(about(unit(frequency)));
          line("natural frequencies",
               format("{} {}, the lowest of those that an impact excites",
                      fmt::join(values, ", "),
                      unit.name));
        }
      catch (const ComputationError &)
        {
          line("natural frequencies", "cannot be estimated for this plate");
        }

      void
      add_cost()
      try
        {
          // more than two digits would not be known
          const auto roughly = [](const double count) {
            return rounded(count < 10. ? std::round(count) : count, 2);
          };
          const Expectation::Cost cost = expected->cost(parameters);
          const Stretching stretching  = expected->zener.section.stretching;
          const double     n_fields = stretching == Stretching::none ? 3. : 5.;
          line("cost",
               format(
                 "of the order of {} cells, {} unknowns, {} steps{} a mesh",
                 roughly(cost.cells),
                 roughly(4. * n_fields * cost.cells),
                 roughly(cost.steps),
                 stretching == Stretching::large ? " of several solves" : ""));
        }
      catch (const ComputationError &)
        {
          line("cost", "cannot be estimated for this plate");
        }

      void
      add_advice()
      {
        if (expected->is_bound)
          return line("step, end time, cost",
                      "cannot be estimated for this plate");
        const TimeParameters &time  = parameters.time;
        const double          rise  = expected->history.peak().time;
        const std::string     steps = format("{} s is {} steps to the peak",
                                         about(time.time_step),
                                         about(rise / time.time_step));
        if (time.step_is_chosen)
          line("Time/Time step",
               format("0: the program chooses it; {}{}",
                      parameters.adaptivity.is_for_peak_force() ? "at first " :
                                                                  "",
                      steps));
        else if (expected->crossings_before_peak(parameters))
          line("Time/Time step",
               "0: the ripples on a late peak need far shorter steps than "
               "its rise; the scene's " +
                 steps);
        else
          line("Time/Time step",
               format("at most {} s for 0.1 %, or 0; the scene's {}",
                      about(0.04 * rise),
                      steps));
        line("Time/End time",
             format("about {} s covers the {}; the scene's is {}",
                    about(expected->contact_end ? 1.1 * *expected->contact_end :
                                                  2. * rise),
                    expected->contact_end ? "contact" : "peak",
                    time.end_time > 0. ? about(time.end_time) + " s" :
                                         "the end of the contact"));
        if (parameters.contact.load_is_singular())
          line("Contact",
               "under a point load the peak force does not converge under "
               "refinement; choose Load distribution = Hertz disc");
        add_cost();
      }

      /// What `plate-impact sweep` makes of the scene's section Sweep.
      void
      add_sweep()
      {
        const Parameters &given    = scene.given;
        const SweepPlan  &plan     = scene.sweep;
        const std::size_t n_points = plan.n_points;
        if (n_points == 0)
          return;
        const bool is_adaptive = plan.may_adapt(given);
        const bool has_own_meshes =
          is_adaptive && given.sweep.adapts_each_point;
        const SweepGroups groups(plan, given);
        const std::string reason = what_keeps_loads_apart(given, plan);
        const std::size_t n_plates =
          has_own_meshes ? n_points : groups.groups.size();
        // what impactors choose is rounded, so that they differ in some hundred
        // ways
        const bool has_own_loads = has_own_meshes || given.sweep.estimate_error;
        const std::size_t n_loads = has_own_loads ? n_points :
          reason.empty()                          ? groups.n_loads :
                           std::min(n_points, 200 * groups.n_loads);

        text += "\nSweep\n";
        line("points", counted(n_points, "impact") + " of " + plan.names());
        line("models",
             format(
               "{}{}{}{} to a load{}",
               counted(n_plates, "plate"),
               is_adaptive ? " on adapted meshes, " : ", ",
               has_own_loads || reason.empty() ? "" : "up to ",
               counted(n_loads, "response"),
               !has_own_meshes && n_loads > groups.n_loads ?
                 format(": {}; otherwise {} would do", reason, groups.n_loads) :
                 ""));
      }

      const Scene               &scene;
      const Parameters          &parameters = scene.parameters;
      std::optional<Expectation> expected; ///< of an impactor
    };
  } // namespace



  std::string
  expectation_in_words(const Scene &scene)
  {
    return ExpectationText(scene).text;
  }
} // namespace PlateImpact
