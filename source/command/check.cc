// What to expect of a scene before paying for it.
#include "plate_impact/analysis/expected_cost.h"
#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/command/commands.h"
#include "plate_impact/plate/plate_file.h"
#include "plate_impact/plate/plate_geometry.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  namespace
  {
    using fmt::format;


    /// On a uniform mesh of the best element.
    PlateModel
    coarse_plate(Parameters                         parameters,
                 const std::array<unsigned int, 2> &n_cells)
    {
      parameters.discretization.element = ElementType::MITC9;
      return {parameters.plate,
              parameters.discretization,
              make_plate_mesh(parameters.plate, n_cells)};
    }



    /// The impact on a coarse mesh, in steps of 1/64 of the contact, up to its
    /// end: where the contact outlasts what Zener's equation expects, end and
    /// step are extended together, and the steps at last made finer.
    CycleResult
    coarse_impact(Parameters parameters, const ZenerImpact &expected)
    {
      std::array<unsigned int, 2> n_cells  = {{8, 8}};
      const auto                  geometry = geometry_of(parameters.plate);
      // Zener's equation, which gives short waves, is of no help for a cylinder
      for (unsigned int d = 0; d < 2; ++d)
        if (parameters.impactor.is_cylinder())
          n_cells[d] = static_cast<unsigned int>(
            std::clamp(2. * (geometry.end[d] - geometry.begin[d]) /
                           expected.wave().length +
                         1.,
                       8.,
                       32.));
      PlateModel plate     = coarse_plate(parameters, n_cells);
      const bool is_held   = std::isfinite(plate.static_compliance(parameters));
      TimeParameters &time = parameters.time;
      time.integrator      = IntegratorType::Ritz_vectors;
      CycleResult result;
      result.cells         = plate.discretization().mesh().n_active_cells();
      result.min_cell_size = smallest_cell_size(plate.discretization().mesh());
      const auto strike    = [&] {
        result.history = plate.under(parameters, false).strike().history;
      };
      const double first_end = 1.5 * expected.contact_time();
      for (time.end_time = first_end;; time.end_time *= 2.)
        {
          time.time_step = time.end_time / 96.;
          strike();
          if (result.history->end_of_impact(is_held) ||
              time.end_time > 1e6 * expected.contact_time())
            break;
        }
      // waves that are back shake a late peak faster than it rises
      if (time.end_time > first_end)
        {
          time.time_step /= 16.;
          strike();
        }
      return result;
    }



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



    /// Whether impactors may be light and heavy, which the plate has different
    /// masses for.
    bool
    sweeps_impactor_mass(const SweepPlan &plan)
    {
      return plan.sweeps("Impactor/Mass") || plan.sweeps("Impactor/Density") ||
        plan.sweeps("Impactor/Radius") || plan.sweeps("Impactor/Length") ||
        plan.sweeps("Impactor/Shape");
    }



    /// What is printed: nothing is said of a scene that fails.
    class ExpectationText
    {
    public:
      explicit ExpectationText(const Scene &scene)
        : text(scene.name + " is a valid scene.\n")
        , scene(scene)
      {
        if (zener)
          expect();
        else
          text += "There is no impactor: the plate stays at rest.\n";
        text += "\nExpected\n";
        if (zener)
          {
            add_impact();
            add_waves();
          }
        add_frequencies();
        if (!zener)
          return;
        text += "\nAdvice\n";
        add_advice();
        add_sweep();
        for (const std::string &warning : warnings.all())
          text += "  warning: " + in_ascii(warning) + '\n';
      }

      std::string text;

    private:
      void
      line(const std::string &name, const std::string &sentence)
      {
        text += format("  {:<22}{}\n", name, in_ascii(sentence));
      }

      /// The impact on a coarse mesh or, where that does not carry the waves,
      /// on Zener's infinite plate until waves are back from the edges.
      void
      expect()
      {
        const BendingWave wave   = zener->wave();
        CycleResult       impact = coarse_impact(parameters, *zener);
        const bool is_resolved   = impact.min_cell_size < 0.5 * wave.length;
        until                    = impact.history->states.back().time;
        contact_end              = impact.history->last_end_of_impact();
        source = "on a coarse mesh of " + counted(impact.cells, "cell");
        if (!is_resolved)
          {
            until       = first_reflection(wave.group_speed);
            contact_end = zener->history(until).end_of_impact();
            source =
              "for an infinite plate, since the waves are too short for a "
              "coarse mesh";
            impact.history =
              zener->history(parameters.time.end_time > 0. ?
                               std::min(until, parameters.time.end_time) :
                               until);
          }
        is_bound = parameters.impactor.is_cylinder() && !is_resolved;
        history  = *impact.history;
        impact.min_cell_size = parameters.adaptivity.minimum_cell_size;
        if (!is_bound)
          warnings = model_warnings({parameters, *zener, impact});
      }

      void
      add_impact()
      {
        const ContactState &peak = history.peak();
        if (is_bound)
          {
            line("peak force",
                 format("above {}, {}", about(peak.force, "N"), source));
            line("contact time", "cannot be estimated for this plate");
          }
        else
          {
            line("peak force",
                 format("about {} at {}, {}",
                        about(peak.force, "N"),
                        about(peak.time, "s"),
                        source));
            line("contact time",
                 (contact_end ? "about " : "more than ") +
                   about(contact_end.value_or(until), "s"));
            line("indentation",
                 format("about {}; deflection of the plate under the load {}",
                        about(peak.indentation, "m"),
                        about(history.max_plate_displacement(), "m")));
          }
        line("infinite plate",
             format("{} at {}, by Zener's equation{}",
                    about(zener->peak.force, "N"),
                    about(zener->peak.time, "s"),
                    parameters.impactor.is_cylinder() ?
                      ", for contact at a point" :
                      ""));
        const ContactState rigid = zener->peak_on_rigid_plate();
        line("half-space",
             format("{} at {}, on a plate that does not move: the upper "
                    "bound of a single contact",
                    about(rigid.force, "N"),
                    about(rigid.time, "s")));
        if (!warnings.contact.empty())
          line("contact", warnings.contact);
        if (parameters.contact.patch_radius > 0.)
          line("load",
               word_for(parameters.contact.load_distribution) + " of " +
                 about(parameters.contact.patch_radius, "m"));
      }

      /// When waves of some speed are back from the edge that is nearest to
      /// the load. [s]
      double
      first_reflection(const double speed) const
      {
        const ContactParameters &contact = parameters.contact;
        const auto [x, y]        = geometry_of(parameters.plate).distance_along;
        const double half_length = contact.load_has_length() ?
          0.5 * parameters.impactor.length :
          contact.patch_radius;
        const double half_width =
          contact.load_is_line() ? 0. : contact.patch_radius;
        return 2. * std::max(0., std::min(x - half_length, y - half_width)) /
          speed;
      }

      /// How many times the fastest ones have come back before the peak, where
      /// that is many: the slower ones that carry the force are then back a few
      /// times.
      std::optional<double>
      crossings_before_peak() const
      {
        const double crossings =
          history.peak().time / first_reflection(zener->section.fastest_wave());
        return crossings > 5. ? std::optional(crossings) : std::nullopt;
      }

      void
      add_waves()
      {
        line("first reflection",
             format("back at {}; until then the supports have no effect",
                    about(first_reflection(zener->section.fastest_wave()),
                          "s")));
        if (const auto n = crossings_before_peak())
          line("peak",
               format("late: the fastest waves cross the plate {} times "
                      "before the peak, so a small error needs many cells",
                      rounded(std::floor(*n), 3)));

        // the first are those that the warnings of a run speak of
        const double      wavelength = zener->wave().length;
        const double      h          = initial_cell_size(parameters);
        const std::string of_contact = contact_end ?
          format(" and {} of the whole contact",
                 about(zener->wave(*contact_end).length, "m")) :
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
            coarse_plate(parameters, {{8, 8}}).natural_frequencies(4);
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
          const TimeParameters &time = parameters.time;
          const double          end =
            time.end_time > 0. ? time.end_time : contact_end.value_or(until);
          const auto [n_x, n_y]       = parameters.discretization.initial_cells;
          const double n_cells        = parameters.plate.is_from_file() ?
                   parameters.plate.file->mesh.n_active_cells() :
                   double(n_x) * n_y;
          const auto [cells, steps]   = parameters.adaptivity.is_adaptive() ?
              expected_cost(parameters) :
              ExpectedCost{n_cells, end / time.time_step};
          const Stretching stretching = zener->section.stretching;
          const double     n_fields = stretching == Stretching::none ? 3. : 5.;
          line("cost",
               format(
                 "of the order of {} cells, {} unknowns, {} steps{} a mesh",
                 roughly(cells),
                 roughly(4. * n_fields * cells),
                 roughly(steps),
                 stretching == Stretching::large ? " of several solves" : ""));
        }
      catch (const ComputationError &)
        {
          line("cost", "cannot be estimated for this plate");
        }

      void
      add_advice()
      {
        if (is_bound)
          return line("step, end time, cost",
                      "cannot be estimated for this plate");
        const TimeParameters &time  = parameters.time;
        const double          rise  = history.peak().time;
        const std::string     steps = format("{} s is {} steps to the peak",
                                         about(time.time_step),
                                         about(rise / time.time_step));
        const bool is_refined       = parameters.adaptivity.is_for_peak_force();
        line("Time/Time step",
             (time.step_is_chosen ?
                "0: the program chooses it; " +
                  std::string(is_refined ? "at first " : "") :
                crossings_before_peak() ?
                "0: the ripples on a late peak need far shorter steps than "
                "its rise; the scene's " :
                "at most " + about(0.04 * rise) +
                  " s for 0.1 %, or 0; the scene's ") +
               steps);
        line("Time/End time",
             format("about {} s covers the {}; the scene's is {}",
                    about(contact_end ? 1.1 * *contact_end : 2. * rise),
                    contact_end ? "contact" : "peak",
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
        const Parameters &given = scene.given;
        const SweepPlan  &plan  = scene.sweep;
        if (plan.n_points == 0)
          return;
        const bool is_adaptive = plan.may_adapt(given);
        const bool has_own_meshes =
          is_adaptive && given.sweep.adapts_each_point;
        const SweepGroups groups(plan, given);
        const std::string reason = what_keeps_loads_apart(given, plan);
        const bool        has_own_plates =
          has_own_meshes || given.sweep.estimate_error;
        const bool may_need_two = !has_own_plates && sweeps_impactor_mass(plan);
        const std::size_t n_masses = may_need_two ? 2 : 1,
                          n_plates = has_own_plates ?
          plan.n_points :
          n_masses * groups.groups.size(),
                          n_fewest = n_masses * groups.n_loads;
        // what impactors choose is rounded, so that they differ in some hundred
        // ways
        const std::size_t n_loads = has_own_plates ? plan.n_points :
          reason.empty()                           ? n_fewest :
                           std::min(plan.n_points, 200 * n_fewest);

        text += "\nSweep\n";
        line("points",
             counted(plan.n_points, "impact") + " of " + plan.names());
        line("models",
             format("{}{}{}{}{} to a load{}",
                    may_need_two ? "up to " : "",
                    counted(n_plates, "plate"),
                    is_adaptive ? " on adapted meshes, " : ", ",
                    has_own_plates || reason.empty() ? "" : "up to ",
                    counted(n_loads, "response"),
                    !has_own_meshes && n_loads > n_fewest ?
                      format(": {}; otherwise {} would do", reason, n_fewest) :
                      ""));
      }

      const Scene      &scene;
      const Parameters &parameters = scene.parameters;
      /// on the infinite plate
      const std::optional<ZenerImpact> &zener = scene.expected;

      ContactHistory        history;          ///< up to the scene's end at most
      std::optional<double> contact_end;      ///< of the impact [s]
      double                until = 0.;       ///< when what is known ends [s]
      std::string           source;           ///< where it comes from
      bool                  is_bound = false; ///< whether the force is larger

      Warnings warnings; ///< of the model
    };
  } // namespace



  std::string
  expectation_in_words(const Scene &scene)
  {
    return ExpectationText(scene).text;
  }
} // namespace PlateImpact
