#include "plate_impact/scene/scene_checker.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/contact/contact_area.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"
#include "plate_impact/scene/plate_checker.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  SceneChecker::SceneChecker(SceneSchema                       &schema,
                             const Parameters                  &parameters,
                             const std::set<std::string>       &swept,
                             const std::optional<ExpectedPeak> &expected_peak)
    : mistakes(schema, swept)
    , expected_peak(expected_peak)
    , schema(schema)
    , scene(parameters)
  {}



  const Parameters &
  SceneChecker::parameters() const
  {
    return scene;
  }



  void
  SceneChecker::choose(const std::string &section,
                       const std::string &entry,
                       double            &variable,
                       const double       value)
  {
    variable = value;
    schema.choose(section, entry, shortest(value));
  }



  template <typename Choice>
  void
  SceneChecker::choose_unless_given(const std::string &entry,
                                    Choice            &variable,
                                    const Choice       value)
  {
    const std::string path = "Contact/" + entry;
    if (schema.origin(path) != "default" || mistakes.is_swept(path))
      return;
    variable = value;
    schema.choose("Contact", entry, word_for(value));
  }



  void
  SceneChecker::choose_contact()
  {
    ContactParameters &contact = scene.contact;
    if (scene.impactor.is_cylinder())
      {
        choose_unless_given("Law", contact.law, ForceLaw::line);
        choose_unless_given("Load distribution",
                            contact.load_distribution,
                            LoadShape::strip);
      }
    else if (scene.plate.is_laminate())
      choose_unless_given("Law", contact.law, ForceLaw::Sun);
    if (contact.law == ForceLaw::Sun || !contact.has_patch() ||
        scene.plate.is_laminate() || contact.unloading != UnloadingLaw::elastic)
      choose_unless_given("Local response",
                          contact.local_response,
                          LocalResponse::half_space);
  }



  void
  SceneChecker::check_together()
  {
    PlateChecker plate(schema, scene, mistakes);
    plate.read();
    plate.check_section();
    choose_contact();
    plate.check_shape();
    check_contact();
    check_unloading();
    check_time();
    check_mesh();
    check_comparison();
  }



  void
  SceneChecker::check_unloading()
  {
    if (!scene.has_impactor() ||
        scene.contact.unloading == UnloadingLaw::elastic)
      return;
    if (scene.impactor.is_cylinder())
      mistakes.refuse({"Contact/Unloading", "Impactor/Shape"},
                      "is a law of spheres; expected elastic for a cylinder");
    if (scene.contact.local_response == LocalResponse::layer)
      mistakes.refuse(
        {"Contact/Unloading", "Contact/Local response"},
        "is a law of half-spaces; expected elastic, or Local response = "
        "half-space");
  }



  void
  SceneChecker::check_contact()
  {
    if (!scene.has_impactor())
      return;
    const bool                     is_cylinder   = scene.impactor.is_cylinder();
    const std::vector<std::string> law_and_shape = {"Contact/Law",
                                                    "Impactor/Shape"};
    if (is_cylinder && scene.contact.law != ForceLaw::line)
      mistakes.refuse(law_and_shape,
                      "is a law of spheres; expected line for a cylinder");
    if (!is_cylinder && scene.contact.law == ForceLaw::line)
      mistakes.refuse(
        law_and_shape,
        "is the law of a cylinder; expected Sun or Hertz for a sphere");
    if (is_cylinder != scene.contact.load_has_length())
      mistakes.refuse({"Contact/Load distribution", "Impactor/Shape"},
                      is_cylinder ?
                        "does not fit a cylinder; expected line or strip" :
                        "does not fit a sphere; expected Hertz disc, uniform "
                        "disc or point");
    if (scene.plate.is_laminate() && scene.contact.law == ForceLaw::Hertz)
      mistakes.refuse(
        {"Contact/Law", "Plate/Layup"},
        "takes the plate for isotropic; expected Sun on a laminate");
    if (scene.plate.is_laminate() &&
        scene.contact.local_response == LocalResponse::layer)
      mistakes.refuse({"Contact/Local response", "Plate/Layup"},
                      "is that of an isotropic plate; expected half-space on a "
                      "laminate, whose local error is not known");
    else if (scene.contact.local_response == LocalResponse::layer)
      {
        if (scene.contact.law == ForceLaw::Sun)
          mistakes.refuse(
            {"Contact/Local response", "Contact/Law"},
            "does not fit the law Sun, whose compliance of the plate is "
            "not that of its material; expected Law = Hertz, or Local "
            "response = half-space");
        if (!scene.contact.has_patch())
          mistakes.refuse(
            {"Contact/Local response", "Contact/Load distribution"},
            "needs a load patch; expected Load distribution = Hertz disc, "
            "uniform disc or strip, or Local response = half-space");
      }
    if (scene.contact.load_is_line() &&
        !geometry_of(scene.plate)->is_symmetric(1))
      mistakes.refuse(
        {"Contact/Load distribution",
         "Plate/Impact point",
         "Plate/Outline",
         "Plate/Layup"},
        "is a line along which the shear force jumps, and has its stress "
        "recovered only where the plate mirrors in it; expected Load "
        "distribution = strip for this impact point, outline and lay-up");
    const double longest = 2. * geometry_of(scene.plate)->distance_to_edge(0);
    if (is_cylinder && longest > 0. && scene.impactor.length > longest)
      mistakes.refuse(
        {"Impactor/Length", "Plate/Side lengths", "Plate/Impact point"},
        "m reaches beyond the plate; expected at most twice the distance "
        "to its nearer edge along x, " +
          number(longest) + " m");
  }



  void
  SceneChecker::check_time()
  {
    const TimeParameters &time = scene.time;
    if (time.end_time > 0. && time.time_step > time.end_time)
      mistakes.refuse({"Time/Time step", "Time/End time"},
                      "s is longer than End time, " + number(time.end_time) +
                        " s");
    if (time.newmark_beta < 0.5 * time.newmark_gamma)
      mistakes.refuse(
        {"Time/Newmark beta", "Time/Newmark gamma"},
        "is below half of Newmark gamma, so that the scheme is unstable "
        "on fine meshes; expected at least " +
          number(0.5 * time.newmark_gamma));
    if (scene.contact.integration == ForceIntegration::energy_conserving &&
        (time.newmark_beta != 0.25 || time.newmark_gamma != 0.5))
      mistakes.refuse(
        {"Contact/Integration", "Time/Newmark beta", "Time/Newmark gamma"},
        "needs Newmark beta = 0.25 and Newmark gamma = 0.5, which alone "
        "conserve energy; with others set Integration = collocation");
  }



  void
  SceneChecker::check_mesh()
  {
    const auto &cells = scene.discretization.initial_cells;
    if (static_cast<double>(cells[0]) * cells[1] > 250000.)
      mistakes.refuse({"Discretization/Initial cells"},
                      "are more than 250000 cells");
    const double h = initial_cell_size(scene);
    if (scene.adaptivity.minimum_cell_size > h)
      mistakes.refuse({"Adaptivity/Minimum cell size",
                       "Plate/Side lengths",
                       "Discretization/Initial cells"},
                      "m is larger than the initial cells, " + number(h) +
                        " m");
    const AdaptivityParameters &adaptivity = scene.adaptivity;
    if (adaptivity.maximum_cell_size > 0. &&
        adaptivity.maximum_cell_size < adaptivity.minimum_cell_size)
      mistakes.refuse({"Adaptivity/Maximum cell size",
                       "Adaptivity/Minimum cell size"},
                      "m is below Minimum cell size, " +
                        number(adaptivity.minimum_cell_size) + " m");
    if (adaptivity.goal == AdaptationGoal::peak_force)
      check_goal();
    if (adaptivity.refined_share_of_error +
          adaptivity.coarsened_share_of_error >
        1.)
      mistakes.refuse({"Adaptivity/Refined share of error",
                       "Adaptivity/Coarsened share of error"},
                      "and Coarsened share of error are together more than 1");
    if (adaptivity.refined_share_of_cells +
          adaptivity.coarsened_share_of_cells >
        1.)
      mistakes.refuse({"Adaptivity/Refined share of cells",
                       "Adaptivity/Coarsened share of cells"},
                      "and Coarsened share of cells are together more than 1");
  }



  void
  SceneChecker::check_goal()
  {
    if (scene.contact.load_is_singular())
      mistakes.refuse(
        {"Adaptivity/Goal", "Contact/Load distribution"},
        "has no meaning under a point load, whose peak force has no limit "
        "under refinement; expected Load distribution = Hertz disc or "
        "uniform disc, or Goal = energy norm");
    if (scene.time.newmark_beta != 0.25 || scene.time.newmark_gamma != 0.5)
      mistakes.refuse(
        {"Adaptivity/Goal", "Time/Newmark beta", "Time/Newmark gamma"},
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
        mistakes.refuse({path}, "names " + word_for(*twice) + " twice");
    };
    const ComparisonParameters &comparison = scene.comparison;
    refuse_repetition("Comparison/Strategies", comparison.strategies);
    refuse_repetition("Comparison/Elements", comparison.elements);
  }



  void
  SceneChecker::complete()
  {
    if (!scene.has_impactor())
      return;
    complete_impactor();
    if (!expected_peak)
      return;
    complete_time(*expected_peak);
    complete_contact(*expected_peak);
    if (!scene.contact.has_patch() || scene.contact.patch_radius > 0.)
      complete_mesh();
  }



  void
  SceneChecker::complete_impactor()
  {
    const Impactor impactor = make_impactor(scene.impactor);
    if (!std::isnormal(impactor.kinetic_energy()))
      return mistakes.refuse(
        {"Impactor/Velocity", "Impactor/Mass", "Impactor/Radius"},
        "m/s gives the impactor an energy of " +
          fmt::format("{:.6g}", impactor.kinetic_energy()) +
          " J, which is beyond what can be computed with");
    if (scene.impactor.mass == 0.)
      choose("Impactor", "Mass", scene.impactor.mass, impactor.mass);
    if (expected_peak)
      return;
    try
      {
        expected_peak = zener_peak(scene);
      }
    catch (const ComputationError &error)
      {
        mistakes.refuse({"Impactor/Velocity", "Impactor/Mass"},
                        "m/s gives no finite force in Zener's equation: " +
                          std::string(error.what()));
      }
  }



  void
  SceneChecker::complete_time(const ExpectedPeak &peak)
  {
    const AdaptivityParameters &adaptivity  = scene.adaptivity;
    const bool                  is_for_peak = adaptivity.is_for_peak_force();
    if (scene.time.time_step == 0.)
      {
        TimeParameters time = scene.time;
        // what the step really costs is measured (TimeControl)
        if (is_for_peak)
          time.step_tolerance = adaptivity.target_peak_force_error;
        choose("Time",
               "Time step",
               scene.time.time_step,
               chosen_time_step(time,
                                make_half_space_contact(scene),
                                make_impactor(scene.impactor),
                                PlateSection(scene.plate)));
        scene.time.step_is_chosen = true;
      }
    if (is_for_peak && schema.origin("Time/Ritz tolerance") == "default")
      choose("Time",
             "Ritz tolerance",
             scene.time.ritz_tolerance,
             0.02 * adaptivity.target_peak_force_error);
    if (scene.time.end_time / scene.time.time_step > 1e8)
      mistakes.refuse({"Time/Time step", "Time/End time"},
                      "s needs more than 1e8 steps to reach End time, " +
                        number(scene.time.end_time) + " s");
    // a contact lasts about twice the time to its peak
    const double longest_step = 25. * 2. * peak.time;
    if (scene.time.time_step > longest_step)
      mistakes.refuse(
        {"Time/Time step", "Impactor/Mass", "Impactor/Velocity"},
        "s is more than 25 times as long as the contact, which Zener's "
        "equation expects to last " +
          number(2. * peak.time) + " s; expected at most " +
          number(longest_step) + " s");
  }



  void
  SceneChecker::check_layer(const ExpectedPeak &peak,
                            const bool          radius_is_given)
  {
    const double largest = make_contact(scene).largest_force();
    if (peak.force <= largest)
      return;
    const std::string forces = number(largest, "N") +
      ", and Zener's equation expects " + number(peak.force, "N") +
      "; expected ";
    if (radius_is_given)
      mistakes.refuse({"Contact/Patch radius", "Contact/Local response"},
                      "m is so small that the local response of a layer holds "
                      "up to " +
                        forces +
                        "0, a larger radius, or Local response = half-space");
    else
      mistakes.refuse({"Plate/Young's modulus",
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
  SceneChecker::complete_contact(const ExpectedPeak &peak)
  {
    if (!scene.contact.has_patch())
      return;
    const bool is_layer = scene.contact.local_response == LocalResponse::layer;
    if (scene.contact.patch_radius > 0.)
      {
        if (is_layer)
          check_layer(peak, /*radius_is_given=*/true);
        return;
      }
    const double thickness = scene.plate.thickness;
    const double to_edge   = geometry_of(scene.plate)->distance_to_edge();
    if (is_layer)
      {
        // the functional with div theta stands in for radii that are too small
        const double of_layer = thickness *
          std::max(0.2,
                   LayerResponse(scene.plate, scene.contact.load_distribution)
                     .patch_radius());
        if (of_layer > to_edge)
          return mistakes.refuse(
            {"Plate/Impact point",
             "Plate/Side lengths",
             "Contact/Patch radius"},
            "m is nearer to an edge, " + number(to_edge) +
              " m, than the load patch of a layer is wide, " +
              number(of_layer) + " m; expected a point farther from it");
        choose("Contact", "Patch radius", scene.contact.patch_radius, of_layer);
        return check_layer(peak, /*radius_is_given=*/false);
      }
    const double radius = contact_radius(scene, peak.force, peak.indentation);
    if (radius > to_edge)
      return mistakes.refuse(
        {"Contact/Patch radius",
         "Plate/Side lengths",
         "Impactor/Radius",
         "Impactor/Velocity"},
        "lets the program choose the Hertz contact radius, "
        "which is " +
          number(radius) + " m and reaches beyond the plate");
    // one of few, so that similar impactors share their load; what that changes
    // of the radius, half a per cent at most, is a ten thousandth of the force
    // of the steel case
    choose("Contact",
           "Patch radius",
           scene.contact.patch_radius,
           thickness *
             std::exp2(std::lround(64. * std::log2(radius / thickness)) / 64.));
  }



  void
  SceneChecker::complete_mesh()
  {
    // a round plate is the same wherever a sphere strikes at one radius, and
    // half of it is enough
    if (auto &point = scene.plate.impact_point; scene.plate.is_circle() &&
        !scene.plate.is_laminate() && !scene.impactor.is_cylinder())
      point = {{std::hypot(point[0], point[1]), 0.}};
    if (scene.adaptivity.maximum_cell_size == 0.)
      choose("Adaptivity",
             "Maximum cell size",
             scene.adaptivity.maximum_cell_size,
             initial_cell_size(scene));
    if (scene.adaptivity.minimum_cell_size == 0.)
      choose("Adaptivity",
             "Minimum cell size",
             scene.adaptivity.minimum_cell_size,
             0.25 *
               (scene.contact.has_patch() ? scene.contact.patch_radius :
                                            scene.plate.thickness));
  }
} // namespace PlateImpact
