#include "plate_impact/expectation.h"

#include "plate_impact/contact_law.h"
#include "plate_impact/impactor.h"
#include "plate_impact/plate_section.h"
#include "plate_impact/zener.h"

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
      Parameters rigid      = parameters;
      rigid.plate.thickness = 1e6 * parameters.plate.thickness;
      return zener_peak(*make_contact_law(parameters),
                        make_impactor(parameters.impactor),
                        PlateSection(rigid.plate));
    }



    /// Force and contact time, with those on a rigid plate as a bound.
    void
    print_peak(std::ostream       &out,
               const Parameters   &parameters,
               const ExpectedPeak &peak,
               const ExpectedPeak &rigid)
    {
      if (parameters.impactor.shape == "cylinder")
        {
          // Zener's plate is struck at a point and gives way more than along a
          // line
          print_line(out,
                     "peak force",
                     "between ",
                     peak.force,
                     " N, struck at a point, and ",
                     rigid.force,
                     " N, on a rigid plate");
          print_line(out,
                     "contact time",
                     "between ",
                     2. * peak.time,
                     " s and ",
                     2. * rigid.time,
                     " s");
          return;
        }
      print_line(out,
                 "peak force",
                 peak.force,
                 " N at ",
                 peak.time,
                 " s; on a rigid plate ",
                 rigid.force,
                 " N, the upper bound");
      print_line(out,
                 "contact time",
                 2. * peak.time,
                 " s; on a rigid plate ",
                 2. * rigid.time,
                 " s");
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
      const double shorter_side =
        std::min(plate.side_lengths[0], plate.side_lengths[1]);
      print_line(out,
                 "first reflection",
                 "back at ",
                 shorter_side / speed,
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
                 const double      contact_time)
    {
      const TimeParameters &time = parameters.time;
      print_line(out,
                 "Time/Time step",
                 "at most ",
                 0.02 * contact_time,
                 " s for 0.1 %; the scene's ",
                 time.time_step,
                 " s is ",
                 contact_time / time.time_step,
                 " steps a contact");
      print_line(out,
                 "Time/End time",
                 "about ",
                 1.5 * contact_time,
                 " s usually covers the first contact; the scene's is ",
                 time.end_time,
                 " s");
      print_line(
        out,
        "Contact",
        parameters.contact.load_distribution,
        parameters.contact.load_distribution == "point" ?
          ": the peak force has no limit under refinement; choose Hertz "
          "disc" :
          "");
    }



    /// Cells and seconds from what scenes of prm/ take: eta falls with the
    /// number of cells, which are spread over the levels of the refinement.
    void
    print_cost(std::ostream &out, const Parameters &parameters)
    {
      const AdaptivityParameters &adaptivity = parameters.adaptivity;
      const auto  &cells   = parameters.discretization.initial_cells;
      const auto  &sides   = parameters.plate.side_lengths;
      const double initial = static_cast<double>(cells[0]) * cells[1];
      const double h = 0.5 * std::max(sides[0] / cells[0], sides[1] / cells[1]);
      double       expected = initial, cycles = 1.;
      if (adaptivity.strategy != "none")
        {
          const double levels =
            std::max(1., std::log2(h / adaptivity.minimum_cell_size));
          expected =
            std::max(initial, 18. * levels * (0.05 / adaptivity.target_error));
          cycles = std::min(4., double(adaptivity.maximum_cycles));
        }
      const double unknowns = 11. * expected,
                   steps = parameters.time.end_time / parameters.time.time_step;
      print_line(out,
                 "cost",
                 "about ",
                 std::lround(expected),
                 " cells, ",
                 std::lround(unknowns),
                 " unknowns, ",
                 0.2 + cycles * steps * unknowns * 1.2e-7,
                 " s, within a factor of three");
    }
  } // namespace



  void
  print_expectation(std::ostream &out, const Scene &scene)
  {
    const Parameters &parameters = scene.parameters;
    out << scene.name << " is a valid scene.\n";
    if (!parameters.has_impactor())
      {
        out << "There is no impactor: the plate stays at rest.\n";
        return;
      }
    const PlateSection section(parameters.plate);
    const ExpectedPeak peak         = zener_peak(*make_contact_law(parameters),
                                         make_impactor(parameters.impactor),
                                         section);
    const double       contact_time = 2. * peak.time;

    out << "\nExpected, by Zener's equation for an infinite thin plate\n";
    print_peak(out, parameters, peak, rigid_plate_peak(parameters));
    print_line(out,
               "indentation",
               peak.indentation,
               " m",
               parameters.contact.patch_radius > 0. ? "; patch radius " : "",
               parameters.contact.patch_radius > 0. ?
                 std::to_string(1e3 * parameters.contact.patch_radius) + " mm" :
                 "");
    print_waves(out, parameters, section, contact_time);
    out << "\nAdvice\n";
    print_advice(out, parameters, contact_time);
    print_cost(out, parameters);
  }
} // namespace PlateImpact
