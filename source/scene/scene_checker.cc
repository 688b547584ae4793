#include "plate_impact/scene/scene_checker.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/contact_bodies.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace PlateImpact
{
  void
  SceneChecker::refuse(const std::vector<std::string> &involved,
                       const std::string              &text)
  {
    std::string origin = "default";
    for (const std::string &path : involved)
      {
        const Entry &entry = entries.at(path);
        if (!entry.is_known)
          return;
        if (origin == "default")
          origin = entry.origin;
      }
    mistakes.push_back(origin + ": " + involved.front() + " = " +
                       entries.at(involved.front()).text() + " " + text);
  }



  bool
  SceneChecker::is_given(const std::string &path) const
  {
    return entries.at(path).origin != "default";
  }



  void
  SceneChecker::choose(const std::string &path,
                       double            &variable,
                       const double       value)
  {
    variable                = value;
    entries.at(path).chosen = shortest(value);
  }



  template <typename Choice>
  void
  SceneChecker::choose_unless_given(const std::string &path,
                                    Choice            &variable,
                                    const Choice       value)
  {
    if (is_given(path))
      return;
    variable                = value;
    entries.at(path).chosen = word_for(value);
  }



  void
  SceneChecker::choose_contact()
  {
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



  SceneChecker::SceneChecker(Entries &entries, const Parameters &given)
    : parameters(given)
    , entries(entries)
  {
    const bool has_outline = read_plate();
    choose_contact();
    ask_for_units("Plate", plate.youngs_modulus, plate.density);
    if (parameters.has_impactor())
      ask_for_units("Impactor", impactor.youngs_modulus, impactor.density);
    check_section();
    if (has_outline)
      check_shape();
    check_contact();
    check_time();
    check_mesh();
    check_comparison();
  }



  void
  SceneChecker::ask_for_units(const std::string &body,
                              const double       modulus,
                              const double       density)
  {
    // one of the two in SI units and the other in those of tables
    if (modulus >= 1. && modulus < 1e3 && density > 100.)
      refuse({body + "/Young's modulus"},
             "Pa is softer than any solid; did you mean " + shortest(modulus) +
               "e9?");
    if (density > 0.5 && density < 30. && modulus > 1e6)
      refuse({body + "/Density"},
             "kg/m^3 is lighter than any solid; did you mean " +
               shortest(1e3 * density) + "?");
  }



  void
  SceneChecker::check_contact()
  {
    if (!parameters.has_impactor())
      return;
    const bool                     is_cylinder   = impactor.is_cylinder();
    const std::vector<std::string> law_and_shape = {"Contact/Law",
                                                    "Impactor/Shape"};
    if (is_cylinder && contact.law != ForceLaw::line)
      refuse(law_and_shape,
             "is a law of spheres; expected line for a cylinder");
    if (!is_cylinder && contact.law == ForceLaw::line)
      refuse(law_and_shape,
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
    if (contact.load_is_line() && !geometry_of(plate)->is_symmetric(1))
      refuse({"Contact/Load distribution",
              "Plate/Impact point",
              "Plate/Outline",
              "Plate/Layup"},
             "makes the shear force jump along a line, and stresses can be "
             "recovered there only if the line is an axis of symmetry of the "
             "plate; expected Load distribution = strip for this impact point, "
             "outline and lay-up");
    const double longest = 2. * geometry_of(plate)->distance_to_edge(0);
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
    if (plate.has_large_deflection() &&
        (time.newmark_beta != 0.25 || time.newmark_gamma != 0.5))
      refuse({"Plate/Deflection", "Time/Newmark beta", "Time/Newmark gamma"},
             "is integrated by the midpoint rule, which conserves energy; "
             "expected Newmark beta = 0.25 and Newmark gamma = 0.5");
    if (contact.integration == ForceIntegration::energy_conserving &&
        (time.newmark_beta != 0.25 || time.newmark_gamma != 0.5))
      refuse({"Contact/Integration", "Time/Newmark beta", "Time/Newmark gamma"},
             "needs Newmark beta = 0.25 and Newmark gamma = 0.5, which alone "
             "conserve energy; with others set Integration = collocation");
  }



  void
  SceneChecker::check_mesh()
  {
    const auto &cells = parameters.discretization.initial_cells;
    if (static_cast<double>(cells[0]) * cells[1] > 250000.)
      refuse({"Discretization/Initial cells"}, "are more than 250000 cells");
    const double h = initial_cell_size(parameters);
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
    if (plate.has_large_deflection())
      refuse({"Adaptivity/Goal", "Plate/Deflection"},
             "needs Plate/Deflection = linear, because its error estimate "
             "holds for linear plates only; expected Goal = energy norm for "
             "large deflections, with Verify = true to check the force");
    if (contact.load_is_singular())
      refuse({"Adaptivity/Goal", "Contact/Load distribution"},
             "has no meaning under a point load, whose peak force does not "
             "converge under refinement; expected Load distribution = Hertz "
             "disc or uniform disc, or Goal = energy norm");
    if (time.newmark_beta != 0.25 || time.newmark_gamma != 0.5)
      refuse({"Adaptivity/Goal", "Time/Newmark beta", "Time/Newmark gamma"},
             "needs Newmark beta = 0.25 and Newmark gamma = 0.5; with others "
             "there is no error bar, set Goal = energy norm");
  }



  void
  SceneChecker::check_comparison()
  {
    const auto refuse_repetition = [this](const std::string &path,
                                          auto               choices) {
      std::sort(choices.begin(), choices.end());
      const auto twice = std::adjacent_find(choices.begin(), choices.end());
      if (twice != choices.end())
        refuse({path}, "names " + word_for(*twice) + " twice");
    };
    const ComparisonParameters &comparison = parameters.comparison;
    refuse_repetition("Comparison/Strategies", comparison.strategies);
    refuse_repetition("Comparison/Elements", comparison.elements);
  }



  void
  SceneChecker::complete()
  {
    if (!mistakes.empty() || !parameters.has_impactor())
      return;
    complete_impactor();
    if (!expected)
      return;
    complete_time();
    complete_contact();
    if (!contact.has_patch() || contact.patch_radius > 0.)
      complete_mesh();
  }



  void
  SceneChecker::complete_impactor()
  {
    const Impactor mass_point = make_impactor(impactor);
    if (!std::isnormal(mass_point.kinetic_energy()))
      return refuse({"Impactor/Velocity", "Impactor/Mass", "Impactor/Radius"},
                    "m/s gives the impactor an energy of " +
                      fmt::format("{:.6g}", mass_point.kinetic_energy()) +
                      " J, which is beyond what can be computed with");
    if (impactor.mass == 0.)
      choose("Impactor/Mass", impactor.mass, mass_point.mass);
    try
      {
        expected.emplace(make_zener_impact(parameters));
      }
    catch (const ComputationError &error)
      {
        refuse({"Impactor/Velocity", "Impactor/Mass"},
               "m/s gives no finite force in Zener's equation: " +
                 std::string(error.what()));
      }
  }



  void
  SceneChecker::complete_time()
  {
    const bool is_for_peak = adaptivity.is_for_peak_force();
    if (time.time_step == 0.)
      {
        TimeParameters to_choose = time;
        // what the step really costs is measured (TimeControl)
        if (is_for_peak)
          to_choose.step_tolerance = adaptivity.target_peak_force_error;
        choose("Time/Time step",
               time.time_step,
               expected->chosen_time_step(to_choose));
        time.step_is_chosen = true;
      }
    if (is_for_peak && !is_given("Time/Ritz tolerance"))
      choose("Time/Ritz tolerance",
             time.ritz_tolerance,
             0.02 * adaptivity.target_peak_force_error);
    if (time.end_time / time.time_step > 1e8)
      refuse({"Time/Time step", "Time/End time"},
             "s needs more than 1e8 steps to reach End time, " +
               number(time.end_time) + " s");
    // a contact lasts about twice the time to its peak
    const double longest_step = 25. * expected->contact_time();
    if (time.time_step > longest_step)
      refuse({"Time/Time step", "Impactor/Mass", "Impactor/Velocity"},
             "s is more than 25 times as long as the contact, which Zener's "
             "equation expects to last " +
               number(expected->contact_time()) + " s; expected at most " +
               number(longest_step) + " s");
  }



  void
  SceneChecker::check_layer(const bool radius_is_given)
  {
    const double largest = make_contact(parameters).largest_force();
    if (expected->peak.force <= largest)
      return;
    const std::string forces = number(largest, "N") +
      ", and Zener's equation expects " + number(expected->peak.force, "N") +
      "; expected ";
    if (radius_is_given)
      refuse({"Contact/Patch radius", "Contact/Local response"},
             "m is so small that the local response of a layer holds "
             "up to " +
               forces + "0, a larger radius, or Local response = half-space");
    else
      refuse({plate.is_laminate() ? "Ply/Transverse modulus" :
                                    "Plate/Young's modulus",
              "Impactor/Velocity",
              "Impactor/Radius",
              "Impactor/Young's modulus",
              "Plate/Thickness"},
             "makes the contact as wide as the plate is thick: the "
             "local response of a layer holds up to " +
               forces +
               "a stiffer plate, a slower or smaller impactor, or "
               "Contact/Local response = half-space");
  }



  void
  SceneChecker::complete_contact()
  {
    impactor.contact_radius =
      ContactBodies(parameters, expected->section)
        .radius(expected->peak.force, expected->peak.indentation);
    if (!contact.has_patch())
      return;
    const bool is_layer = contact.local_response == LocalResponse::layer;
    if (contact.patch_radius > 0.)
      {
        if (is_layer)
          check_layer(/*radius_is_given=*/true);
        return;
      }
    const double thickness = plate.thickness;
    const double to_edge   = geometry_of(plate)->distance_to_edge();
    if (is_layer)
      {
        // the functional with div theta stands in for radii that are too small
        const double of_layer = thickness *
          std::max(0.2,
                   LayerResponse(PlateSection(plate), contact.load_distribution)
                     .patch_radius());
        if (of_layer > to_edge)
          return refuse({"Plate/Impact point",
                         "Plate/Side lengths",
                         "Contact/Patch radius"},
                        "m is only " + number(to_edge) +
                          " m from an edge, less than the radius of the load "
                          "patch, " +
                          number(of_layer) +
                          " m; expected a point farther from the edge");
        choose("Contact/Patch radius", contact.patch_radius, of_layer);
        return check_layer(/*radius_is_given=*/false);
      }
    const double radius = impactor.contact_radius;
    if (radius > to_edge)
      return refuse({"Contact/Patch radius",
                     "Plate/Side lengths",
                     "Impactor/Radius",
                     "Impactor/Velocity"},
                    "lets the program choose the Hertz contact radius, "
                    "which is " +
                      number(radius) +
                      " m and reaches beyond the plate; "
                      "expected a larger plate, or a smaller "
                      "or slower impactor");
    // one of few, so that similar impactors share their load; what that changes
    // of the radius, half a per cent at most, is a ten thousandth of the force
    // of the steel case
    choose("Contact/Patch radius",
           contact.patch_radius,
           thickness *
             std::exp2(std::lround(64. * std::log2(radius / thickness)) / 64.));
  }



  void
  SceneChecker::complete_mesh()
  {
    // a round plate is the same wherever a sphere strikes at one radius, and
    // half of it is enough
    double turn = 0.;
    if (auto &point = plate.impact_point;
        plate.is_circle() && !plate.is_laminate() && !impactor.is_cylinder())
      {
        turn  = std::atan2(point[1], point[0]);
        point = {{std::hypot(point[0], point[1]), 0.}};
      }
    place_singular_points(turn);
    if (adaptivity.maximum_cell_size == 0.)
      choose("Adaptivity/Maximum cell size",
             adaptivity.maximum_cell_size,
             initial_cell_size(parameters));
    adaptivity.minimum_cell_size_is_chosen = adaptivity.minimum_cell_size == 0.;
    if (adaptivity.minimum_cell_size_is_chosen)
      choose("Adaptivity/Minimum cell size",
             adaptivity.minimum_cell_size,
             0.25 *
               (contact.has_patch() ? contact.patch_radius : plate.thickness));
  }
} // namespace PlateImpact
