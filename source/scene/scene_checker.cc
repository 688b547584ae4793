#include "plate_impact/scene/scene_checker.h"

#include "plate_impact/plate/plate_geometry.h"

#include <algorithm>
#include <tuple>

namespace PlateImpact
{
  void
  SceneChecker::choose_contact()
  {
    const auto choose_unless_given =
      [this](const std::string &path, auto &variable, const auto value) {
        if (is_given(path))
          return;
        variable                = value;
        entries.at(path).chosen = word_for(value);
      };
    if (impactor.is_cylinder())
      {
        choose_unless_given("Contact/Law", contact.law, ForceLaw::line);
        choose_unless_given("Contact/Load distribution",
                            contact.load_distribution,
                            LoadShape::strip);
      }
    if (contact.law == ForceLaw::Sun || !contact.has_patch())
      choose_unless_given("Contact/Local response",
                          contact.local_response,
                          LocalResponse::half_space);
  }



  SceneChecker::SceneChecker(SceneReader &reader)
    : Parameters(reader.parameters)
    , reader(reader)
  {
    const bool has_outline = read_plate();
    choose_contact();
    // about a modulus in GPa and a density in g/cm^3
    const auto ask_for_units = [this](const std::string &name,
                                      const auto        &body) {
      const double modulus = body.youngs_modulus, density = body.density;
      // one of the two in SI units and the other in those of tables
      if (modulus >= 1. && modulus < 1e3 && density > 100.)
        refuse({name + "/Young's modulus"},
               "Pa is softer than any solid; did you mean " +
                 shortest(modulus) + "e9?");
      // gels are as soft, but not as heavy
      else if (modulus >= 1e3 && modulus < 1e6 && density > 2000.)
        refuse({name + "/Young's modulus"},
               "Pa is softer than any solid as heavy; did you mean " +
                 shortest(modulus) + "e6?");
      if (density > 0.5 && density < 20. && modulus > 1e6)
        refuse({name + "/Density"},
               "kg/m^3 is lighter than any solid; did you mean " +
                 shortest(1e3 * density) + "?");
    };
    ask_for_units("Plate", plate);
    if (has_impactor())
      ask_for_units("Impactor", impactor);
    check_section();
    if (has_outline)
      check_shape();
    check_contact();
    check_time();
    check_mesh();
    const auto refuse_repetition = [this](const std::string &path,
                                          const auto        &choices) {
      for (const auto &choice : choices)
        if (std::count(choices.begin(), choices.end(), choice) > 1)
          return refuse({path}, "names " + word_for(choice) + " twice");
    };
    refuse_repetition("Comparison/Strategies", comparison.strategies);
    refuse_repetition("Comparison/Elements", comparison.elements);
  }



  void
  SceneChecker::check_contact()
  {
    if (!has_impactor())
      return;
    const bool is_cylinder = impactor.is_cylinder();
    if (is_cylinder != (contact.law == ForceLaw::line))
      refuse({"Contact/Law", "Impactor/Shape"},
             is_cylinder ?
               "is a law of spheres; expected line for a cylinder" :
               "is the law of a cylinder; expected Sun or Hertz for a sphere");
    if (is_cylinder != contact.load_has_length())
      refuse({"Contact/Load distribution", "Impactor/Shape"},
             is_cylinder ?
               "does not fit a cylinder; expected line or strip" :
               "does not fit a sphere; expected Hertz disc, uniform "
               "disc or point");
    if (contact.local_response == LocalResponse::layer)
      {
        if (contact.law == ForceLaw::Sun)
          refuse({"Contact/Local response", "Contact/Law"},
                 "does not fit the law Sun, which does not use the true "
                 "compliance of the plate's material; expected Law = Hertz, or "
                 "Local response = half-space");
        if (!contact.has_patch())
          refuse({"Contact/Local response", "Contact/Load distribution"},
                 "needs a load patch; expected Load distribution = Hertz disc, "
                 "uniform disc or strip, or Local response = half-space");
      }
    if (contact.load_is_line() && !geometry_of(plate).is_symmetric[1])
      refuse({"Contact/Load distribution",
              "Plate/Impact point",
              "Plate/Outline",
              "Plate/Layup"},
             "makes the shear force jump along a line, and stresses can be "
             "recovered there only if the line is an axis of symmetry of the "
             "plate; expected Load distribution = strip for this impact point, "
             "outline and lay-up");
    const double longest = 2. * geometry_of(plate).distance_along[0];
    if (is_cylinder && longest > 0. && impactor.length > longest)
      refuse({"Impactor/Length", "Plate/Side lengths", "Plate/Impact point"},
             "m reaches beyond the plate; expected at most twice the distance "
             "to its nearer edge along x, " +
               number(longest) + " m");
    if (plate.is_laminate() && impactor.yield_strength > 0.)
      refuse({"Impactor/Yield strength", "Plate/Layup"},
             "Pa is for contacts with an isotropic plate only; expected 0 for "
             "a laminate");
    // lead, gold and annealed aluminium have a ten thousandth and more
    const auto check_strength = [this](const std::string &body,
                                       const double       strength,
                                       const double       modulus) {
      if (strength > 0. && strength < 1e-5 * modulus)
        refuse({body + "/Yield strength"},
               "Pa is less than a hundred thousandth of Young's modulus, " +
                 number(modulus) +
                 " Pa, which no solid has; expected pascals, as 235e6");
    };
    if (!plate.is_laminate())
      check_strength("Plate", plate.yield_strength, plate.youngs_modulus);
    check_strength("Impactor",
                   impactor.yield_strength,
                   impactor.youngs_modulus);
    if (contact.unloading == UnloadingLaw::elastic)
      return;
    if (plate.yield_strength > 0. || impactor.yield_strength > 0.)
      refuse({"Contact/Unloading",
              "Plate/Yield strength",
              "Impactor/Yield strength"},
             "is a law of laminates; with a yield strength the contact unloads "
             "by a law of its own; expected elastic");
    if (is_cylinder)
      refuse({"Contact/Unloading", "Impactor/Shape"},
             "is a law of spheres; expected elastic for a cylinder");
  }



  void
  SceneChecker::check_time()
  {
    if (time.end_time > 0. && time.time_step > time.end_time)
      refuse({"Time/Time step", "Time/End time"},
             "s is longer than End time, " + number(time.end_time) + " s");
    if (time.newmark_beta < 0.5 * time.newmark_gamma)
      refuse({"Time/Newmark beta", "Time/Newmark gamma"},
             "is below half of Newmark gamma, so that the scheme is unstable "
             "on fine meshes; expected at least " +
               number(0.5 * time.newmark_gamma));
    if (plate.has_large_deflection && !time.is_average_acceleration())
      refuse({"Plate/Deflection", "Time/Newmark beta", "Time/Newmark gamma"},
             "is integrated by the midpoint rule, which conserves energy; "
             "expected Newmark beta = 0.25 and Newmark gamma = 0.5");
    if (contact.integration == ForceIntegration::energy_conserving &&
        !time.is_average_acceleration())
      refuse({"Contact/Integration", "Time/Newmark beta", "Time/Newmark gamma"},
             "needs Newmark beta = 0.25 and Newmark gamma = 0.5, which alone "
             "conserve energy; with others set Integration = collocation");
  }



  void
  SceneChecker::check_mesh()
  {
    const auto &cells = discretization.initial_cells;
    if (static_cast<double>(cells[0]) * cells[1] > 250000.)
      // no mesh is made of them
      return refuse({"Discretization/Initial cells"},
                    "are more than 250000 cells");
    const double h = initial_cell_size(*this);
    if (adaptivity.minimum_cell_size > h)
      refuse({"Adaptivity/Minimum cell size",
              "Plate/Side lengths",
              "Discretization/Initial cells"},
             "m is larger than the initial cells, " + number(h) + " m");
    if (adaptivity.maximum_cell_size > 0. &&
        adaptivity.maximum_cell_size < adaptivity.minimum_cell_size)
      refuse({"Adaptivity/Maximum cell size", "Adaptivity/Minimum cell size"},
             "m is below Minimum cell size, " +
               number(adaptivity.minimum_cell_size) + " m");
    const auto &a = adaptivity;
    for (const auto &[what, refined, coarsened] :
         {std::tuple<std::string, double, double>{"error",
                                                  a.refined_share_of_error,
                                                  a.coarsened_share_of_error},
          {"cells", a.refined_share_of_cells, a.coarsened_share_of_cells}})
      if (refined + coarsened > 1.)
        refuse({"Adaptivity/Refined share of " + what,
                "Adaptivity/Coarsened share of " + what},
               "and Coarsened share of " + what + " are together more than 1");
    if (adaptivity.goal != AdaptationGoal::peak_force)
      return;
    if (plate.has_large_deflection)
      refuse({"Adaptivity/Goal", "Plate/Deflection"},
             "needs Plate/Deflection = linear, because its error estimate "
             "holds for linear plates only; expected Goal = energy norm for "
             "large deflections, with Verify = true to check the force");
    if (contact.load_is_singular())
      refuse({"Adaptivity/Goal", "Contact/Load distribution"},
             "has no meaning under a point load, whose peak force does not "
             "converge under refinement; expected Load distribution = Hertz "
             "disc or uniform disc, or Goal = energy norm");
    if (!time.is_average_acceleration())
      refuse({"Adaptivity/Goal", "Time/Newmark beta", "Time/Newmark gamma"},
             "needs Newmark beta = 0.25 and Newmark gamma = 0.5; with others "
             "there is no error bar, set Goal = energy norm");
  }
} // namespace PlateImpact
