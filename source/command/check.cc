#include "plate_impact/command/check.h"

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/analysis/reliability.h"
#include "plate_impact/contact/contact_law.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/plate_section.h"
#include "plate_impact/scene/scene_reader.h"
#include "plate_impact/scene/sweep_plan.h"
#include "plate_impact/sweep/sweep_groups.h"
#include "plate_impact/transient/struck_plate.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace PlateImpact
{
  namespace
  {
    /// A line of the page: a name and the parts of its sentence.
    template <typename... Parts>
    void
    print_line(std::ostream      &out,
               const std::string &name,
               const Parts &...parts)
    {
      std::ostringstream text;
      text.precision(3);
      (text << ... << parts);
      out << "  " << std::left << std::setw(22) << name << text.str() << '\n';
    }



    /// Peak of the impact on a plate that does not move.
    ExpectedPeak
    rigid_plate_peak(const Parameters &parameters)
    {
      PlateSection immovable(parameters.plate);
      immovable.mass *= 1e12;
      return zener_peak(*make_contact_law(parameters),
                        make_impactor(parameters.impactor),
                        immovable);
    }



    /// The impact on a coarse mesh, in steps of 1/64 of the contact, up to its
    /// end: where the contact outlasts what Zener's equation expects, end and
    /// step are extended together.
    CycleResult
    coarse_impact(const Parameters &scene,
                  const double      expected_contact_time,
                  const double      wavelength)
    {
      Parameters parameters                   = scene;
      parameters.discretization.initial_cells = {{8, 8}};
      // Zener's equation, which knows short waves, is of no help for a cylinder
      for (unsigned int d = 0; d < 2; ++d)
        if (scene.impactor.is_cylinder())
          parameters.discretization.initial_cells[d] =
            static_cast<unsigned int>(
              std::clamp(scene.plate.side_lengths[d] / wavelength + 1.,
                         8.,
                         32.));
      parameters.discretization.element = ElementType::MITC9;
      parameters.adaptivity.strategy    = AdaptationStrategy::none;
      parameters.output.write_report    = false;
      parameters.output.field_samples   = 0;
      parameters.time.integrator        = IntegratorType::Ritz_vectors;
      parameters.time.end_time          = 1.5 * expected_contact_time;
      StruckPlate plate(
        parameters.plate,
        parameters.discretization,
        make_plate_quadrant(parameters.plate,
                            parameters.discretization.initial_cells));
      CycleResult result;
      result.cells         = plate.discretization().mesh().n_active_cells();
      result.min_cell_size = smallest_cell_size(plate.discretization().mesh());
      while (true)
        {
          parameters.time.time_step = parameters.time.end_time / 96.;
          result.history            = plate.strike(parameters).history;
          const bool is_long =
            parameters.time.end_time > 1e6 * expected_contact_time;
          if (result.history->first_contact_end() || is_long)
            return result;
          parameters.time.end_time *= 2.;
        }
    }



    /// The impact as far as it is known before it is paid for.
    struct Foreknown
    {
      ContactHistory        history; ///< up to the scene's end at most
      std::optional<double> contact_end;
      double                until;    ///< when what is known ends [s]
      std::string           source;   ///< where it comes from
      bool                  is_bound; ///< whether the true force is larger
    };



    void
    print_impact(std::ostream       &out,
                 const Parameters   &parameters,
                 const Foreknown    &known,
                 const ExpectedPeak &zener)
    {
      const ContactState &peak = known.history.peak();
      if (known.is_bound)
        {
          print_line(out,
                     "peak force",
                     "above ",
                     peak.force,
                     " N, ",
                     known.source);
          print_line(out, "contact time", "cannot be said for this plate");
        }
      else
        {
          print_line(out,
                     "peak force",
                     "about ",
                     peak.force,
                     " N at ",
                     peak.time,
                     " s, ",
                     known.source);
          print_line(out,
                     "contact time",
                     known.contact_end ? "about " : "more than ",
                     known.contact_end.value_or(known.until),
                     " s");
          print_line(out,
                     "indentation",
                     "about ",
                     peak.indentation,
                     " m; deflection of the plate under the load ",
                     known.history.max_plate_displacement(),
                     " m");
        }
      print_line(out,
                 "infinite plate",
                 zener.force,
                 " N at ",
                 zener.time,
                 " s, by Zener's equation",
                 parameters.impactor.is_cylinder() ?
                   ", which strikes at a point" :
                   "");
      const ExpectedPeak rigid = rigid_plate_peak(parameters);
      print_line(out,
                 "half-space",
                 rigid.force,
                 " N at ",
                 rigid.time,
                 " s, on a plate that does not move: the upper bound of a "
                 "single contact");
      if (parameters.contact.patch_radius > 0.)
        print_line(out,
                   "load",
                   word_for(parameters.contact.load_distribution),
                   " of ",
                   parameters.contact.patch_radius,
                   " m");
    }



    /// Shortest way from the load to an edge. [m]
    double
    distance_to_edge(const Parameters &parameters)
    {
      const auto  &sides   = parameters.plate.side_lengths;
      const double patch   = parameters.contact.patch_radius;
      const double along_x = parameters.contact.load_has_length() ?
        0.5 * parameters.impactor.length :
        patch;
      return std::max(0.,
                      std::min(0.5 * sides[0] - along_x,
                               0.5 * sides[1] -
                                 (parameters.contact.load_is_line() ? 0. :
                                                                      patch)));
    }



    void
    print_waves(std::ostream       &out,
                const Parameters   &parameters,
                const PlateSection &section,
                const double        contact_time)
    {
      const PlateParameters &plate = parameters.plate;
      const double           nu    = plate.poissons_ratio;
      // the fastest wave of a Reissner-Mindlin plate
      const double speed =
        std::sqrt(plate.youngs_modulus / (plate.density * (1. - nu * nu)));
      print_line(out,
                 "first reflection",
                 "back at ",
                 2. * distance_to_edge(parameters) / speed,
                 " s; before, the supports do not matter");

      const double wavelength = contact_wave(section, contact_time).length;
      const auto  &cells      = parameters.discretization.initial_cells;
      const double h          = 0.5 *
        std::max(plate.side_lengths[0] / cells[0],
                 plate.side_lengths[1] / cells[1]);
      print_line(out,
                 "bending wavelength",
                 wavelength,
                 " m; initial cells of ",
                 h,
                 " m",
                 h > 0.5 * wavelength ?
                   " do not resolve it: more than one cycle "
                   "is needed" :
                   "");
    }



    void
    print_advice(std::ostream     &out,
                 const Parameters &parameters,
                 const Foreknown  &known)
    {
      const TimeParameters &time = parameters.time;
      const double          rise = known.history.peak().time;
      print_line(out,
                 "Time/Time step",
                 "at most ",
                 0.04 * rise,
                 " s for 0.1 %, or 0; the scene's ",
                 time.time_step,
                 " s is ",
                 rise / time.time_step,
                 " steps to the peak");
      if (known.contact_end)
        print_line(out,
                   "Time/End time",
                   "about ",
                   1.1 * *known.contact_end,
                   " s covers the first contact; the scene's is ",
                   time.end_time,
                   " s");
      else
        print_line(out,
                   "Time/End time",
                   "about ",
                   2. * rise,
                   " s covers the peak; the scene's is ",
                   time.end_time,
                   " s");
      if (parameters.contact.load_is_singular())
        print_line(out,
                   "Contact",
                   "under a point load the peak force has no limit under "
                   "refinement; choose Hertz disc");
    }



    struct Cost
    {
      double cells, unknowns, cycles, steps;
      double seconds_of_cycle;
    };



    /// Cells that follow the waves which a contact sends out, to an error eta:
    /// measured on plates of a/t from 200 to 500, 20 on the square of a
    /// wavelength for 5 %; as the error falls with the square of their size, so
    /// grows their number. Waves of nine times the frequency run ahead.
    double
    cells_for_waves(const Parameters &parameters, const BendingWave &wave)
    {
      const auto  &sides = parameters.plate.side_lengths;
      const double reach = 3. * wave.group_speed * parameters.time.end_time;
      const double area  = std::min(0.25 * sides[0] * sides[1],
                                   0.25 * std::acos(-1.) * reach * reach);
      return 20. * area / (wave.length * wave.length) * 0.05 /
        parameters.adaptivity.target_error;
    }



    /// Cells and seconds from what scenes of prm/ take: eta falls with the
    /// number of cells, which are spread over the levels of the refinement and
    /// follow the waves.
    Cost
    cost_of_run(const Parameters &parameters, const BendingWave &wave)
    {
      const AdaptivityParameters &adaptivity = parameters.adaptivity;
      const auto  &cells   = parameters.discretization.initial_cells;
      const auto  &sides   = parameters.plate.side_lengths;
      const double initial = static_cast<double>(cells[0]) * cells[1];
      const double h = 0.5 * std::max(sides[0] / cells[0], sides[1] / cells[1]);
      Cost         cost;
      cost.cells  = initial;
      cost.cycles = 1.;
      if (adaptivity.is_adaptive())
        {
          const double halvings = h / adaptivity.minimum_cell_size;
          cost.cells            = std::clamp(18. * std::log2(halvings) * 0.05 /
                                      adaptivity.target_error +
                                    cells_for_waves(parameters, wave),
                                  initial,
                                  initial * halvings * halvings);
          cost.cells  = std::min(cost.cells, 1. * adaptivity.maximum_cells);
          cost.cycles = std::min(5., double(adaptivity.maximum_cycles));
        }
      cost.unknowns = 12. * cost.cells;
      cost.steps    = parameters.time.end_time / parameters.time.time_step;
      const bool is_reduced =
        parameters.time.integrator == IntegratorType::Ritz_vectors;
      cost.seconds_of_cycle = cost.unknowns * 5e-5 +
        cost.steps * (is_reduced ? 1e-6 : cost.unknowns * 2e-7);
      return cost;
    }



    void
    print_cost(std::ostream &out, const Cost &cost)
    {
      print_line(out,
                 "cost",
                 "of the order of ",
                 cost.cells,
                 " cells, ",
                 cost.unknowns,
                 " unknowns, ",
                 0.2 + cost.cycles * cost.seconds_of_cycle,
                 " s");
    }



    std::string
    counted(const std::size_t n, const std::string &noun)
    {
      return std::to_string(n) + ' ' + noun + (n == 1 ? "" : "s");
    }



    /// Why points that could share a load with its response do not; empty when
    /// they do.
    std::string
    what_keeps_loads_apart(const Parameters &given, const SweepPlan &plan)
    {
      if (given.sweep.estimate_error)
        return "Sweep/Estimate error = true steps every impact by itself";
      if (given.contact.has_patch() && given.contact.patch_radius == 0. &&
          !plan.sweeps("Contact/Patch radius"))
        return "Contact/Patch radius = 0 lets impactors choose";
      if (given.time.time_step == 0. && !plan.sweeps("Time/Time step"))
        return "Time/Time step = 0 lets impactors choose";
      return {};
    }



    /// What `plate-impact sweep` makes of the scene's section Sweep; seconds
    /// from what sweeps of the main scene take.
    void
    print_sweep(std::ostream &out, const Scene &scene, const Cost &cost)
    {
      const Parameters &given = scene.given;
      const SweepPlan   plan(SceneReader().schema, given.sweep);
      const std::size_t n_points = plan.n_points();
      if (n_points == 0)
        return;
      const bool is_adaptive =
        given.adaptivity.is_adaptive() || plan.sweeps("Adaptivity/Strategy");
      const bool has_own_meshes =
        is_adaptive && given.sweep.adapt == SweepAdaptation::each_point;
      const SweepGroups groups(plan, is_adaptive);
      const std::string reason = what_keeps_loads_apart(given, plan);
      const std::size_t n_plates =
        has_own_meshes ? n_points : groups.groups().size();
      // what impactors choose is rounded, so that they differ in some hundred
      // ways
      const bool has_own_loads  = has_own_meshes || given.sweep.estimate_error;
      const std::size_t n_loads = has_own_loads ? n_points :
        reason.empty()                          ? groups.n_loads() :
                         std::min(n_points, 200 * groups.n_loads());

      std::string names;
      for (const SweptEntry &entry : plan.entries())
        names += (names.empty() ? "" : ", ") + entry.path;
      out << "\nSweep\n";
      print_line(out, "points", counted(n_points, "impact"), " of ", names);
      print_line(out,
                 "models",
                 counted(n_plates, "plate"),
                 is_adaptive ? " on adapted meshes, " : ", ",
                 has_own_loads || reason.empty() ? "" : "up to ",
                 counted(n_loads, "response"),
                 " to a load",
                 !has_own_meshes && n_loads > groups.n_loads() ? ": " + reason +
                     "; " + std::to_string(groups.n_loads()) + " would do" :
                                                                 "");
      const bool is_reduced =
        given.time.integrator == IntegratorType::Ritz_vectors;
      const double seconds = 0.2 +
        n_plates * cost.cycles * cost.seconds_of_cycle +
        n_loads * cost.unknowns * (is_reduced ? 1e-5 : 1e-7 * cost.steps) +
        n_points *
          (cost.steps * (is_reduced ? 2e-6 : 1e-6) +
           (given.sweep.estimate_error ? cost.seconds_of_cycle : 0.));
      print_line(out, "cost", "of the order of ", seconds, " s");
    }
  } // namespace



  void
  print_expectation(std::ostream &out, const Scene &scene)
  {
    const Parameters  &parameters = scene.parameters;
    std::ostringstream page;
    page << scene.name << " is a valid scene.\n";
    if (parameters.has_impactor())
      {
        const PlateSection section(parameters.plate);
        const auto         law = make_contact_law(parameters);
        const ExpectedPeak zener =
          zener_peak(*law, make_impactor(parameters.impactor), section);
        // the wave that an infinite plate would carry
        const BendingWave wave = contact_wave(section, 2. * zener.time);
        CycleResult       impact =
          coarse_impact(parameters, 2. * zener.time, wave.length);
        const bool is_resolved = impact.min_cell_size < 0.5 * wave.length;
        double     until       = impact.history->states().back().time;
        std::optional<double> contact_end = impact.history->first_contact_end();
        if (!is_resolved)
          {
            const auto history = [&](const double end) {
              return zener_history(*law,
                                   make_impactor(parameters.impactor),
                                   section,
                                   end);
            };
            // when waves are back from the edges
            until       = 2. * distance_to_edge(parameters) / wave.group_speed;
            contact_end = history(until).first_contact_end();
            impact.history = history(std::min(until, parameters.time.end_time));
          }
        const bool        is_cylinder = parameters.impactor.is_cylinder();
        const std::string source      = is_resolved ?
               "on a coarse mesh of " + std::to_string(impact.cells) + " cells" :
               "on an infinite plate: its waves are too short for a coarse mesh";
        const Foreknown   known       = {*impact.history,
                                         contact_end,
                                         until,
                                         source,
                                         is_cylinder && !is_resolved};

        page << "\nExpected\n";
        print_impact(page, parameters, known, zener);
        print_waves(page,
                    parameters,
                    section,
                    contact_end.value_or(2. * zener.time));
        page << "\nAdvice\n";
        const Cost cost = cost_of_run(parameters, wave);
        if (known.is_bound)
          print_line(page,
                     "step, end time, cost",
                     "cannot be said for this plate");
        else
          {
            print_advice(page, parameters, known);
            print_cost(page, cost);
          }
        print_sweep(page, scene, cost);
        impact.min_cell_size = parameters.adaptivity.minimum_cell_size;
        if (!known.is_bound)
          for (const std::string &warning : model_warnings(parameters, impact))
            page << "  warning: " << warning << '\n';
      }
    else
      page << "There is no impactor: the plate stays at rest.\n";
    // nothing is said of a scene that fails
    out << page.str();
  }
} // namespace PlateImpact
