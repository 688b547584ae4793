// What a scene leaves to the program, and checks of what is chosen.
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/contact_bodies.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/plate_section.h"
#include "plate_impact/scene/scene_checker.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  namespace
  {
    /// Whether the peak is expected after waves have crossed the plate, which
    /// have to keep their frequency: a heavy impactor bends a plate that is
    /// held as a whole. Other waves only leave. They carry away energy as the
    /// root of stiffness times mass, so that more mass would add to the error
    /// of the stiffness.
    bool
    waves_come_back(const Parameters &scene, const ZenerImpact &expected)
    {
      const PlateGeometry geometry = geometry_of(scene.plate);
      const double plate_mass = geometry.area * expected.section.mass_per_area,
                   back = expected.return_of_waves(geometry.distance_to_edge);
      const auto &supports = scene.plate.supports;
      const bool  is_held =
        std::any_of(supports.begin(), supports.end(), [](const auto &on_edge) {
          return on_edge.support != EdgeSupport::free;
        });
      return expected.impactor.mass > 0.5 * plate_mass && is_held &&
        (scene.time.end_time == 0. || scene.time.end_time > back);
    }
  } // namespace



  void
  SceneChecker::complete()
  {
    if (!reader.mistakes.empty() || !has_impactor())
      return;
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
        expected.emplace(make_zener_impact(*this));
      }
    catch (const ComputationError &error)
      {
        return refuse({"Impactor/Velocity", "Impactor/Mass"},
                      "m/s gives no finite force in Zener's equation: " +
                        std::string(error.what()));
      }
    if (waves_come_back(*this, *expected))
      discretization.mass = PlateMass::of_waves;
    complete_time();
    complete_contact();
    if (!contact.has_patch() || contact.patch_radius > 0.)
      complete_mesh();
  }



  void
  SceneChecker::complete_time()
  {
    const bool is_for_peak = adaptivity.is_for_peak_force();
    if (time.time_step == 0.)
      {
        // what the step really costs is measured (TimeControl)
        const double step = expected->chosen_time_step(
          is_for_peak ? adaptivity.target_peak_force_error :
                        time.step_tolerance);
        choose("Time/Time step",
               time.time_step,
               time.end_time > 0. ? std::min(step, time.end_time) : step);
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
  SceneChecker::complete_layer()
  {
    const bool radius_is_given = contact.patch_radius > 0.;
    if (!radius_is_given)
      {
        // the functional with div theta stands in for radii that are too small
        const double to_edge = geometry_of(plate).distance_to_edge;
        const double radius  = plate.thickness *
          std::max(0.2,
                   LayerResponse(PlateSection(plate), contact.load_distribution)
                     .patch_radius());
        if (radius > to_edge)
          return refuse({"Plate/Impact point",
                         "Plate/Side lengths",
                         "Contact/Patch radius"},
                        "m is only " + number(to_edge) +
                          " m from an edge, less than the radius of the load "
                          "patch, " +
                          number(radius) +
                          " m; expected a point farther from the edge");
        choose("Contact/Patch radius", contact.patch_radius, radius);
      }
    const double largest = make_contact(*this).largest_force;
    if (expected->peak.force <= largest)
      return;
    const std::string forces = number(largest, "N") +
      ", and Zener's equation expects " + number(expected->peak.force, "N") +
      "; expected ";
    if (radius_is_given)
      refuse({"Contact/Patch radius", "Contact/Local response"},
             "m is so small that the local response of a layer holds up to " +
               forces + "0, a larger radius, or Local response = half-space");
    else
      refuse({plate.is_laminate() ? "Ply/Transverse modulus" :
                                    "Plate/Young's modulus",
              "Impactor/Velocity",
              "Impactor/Radius",
              "Impactor/Young's modulus",
              "Plate/Thickness"},
             "makes the contact as wide as the plate is thick: the local "
             "response of a layer holds up to " +
               forces +
               "a stiffer plate, a slower or smaller impactor, or "
               "Contact/Local response = half-space");
  }



  void
  SceneChecker::complete_contact()
  {
    impactor.contact_radius =
      ContactBodies(*this, expected->section)
        .radius(expected->peak.force, expected->peak.indentation);
    if (!contact.has_patch())
      return;
    if (contact.local_response == LocalResponse::layer)
      return complete_layer();
    if (contact.patch_radius > 0.)
      return;
    const double radius = impactor.contact_radius;
    if (radius > geometry_of(plate).distance_to_edge)
      return refuse({"Contact/Patch radius",
                     "Plate/Side lengths",
                     "Impactor/Radius",
                     "Impactor/Velocity"},
                    "lets the program choose the Hertz contact radius, which "
                    "is " +
                      number(radius) +
                      " m and reaches beyond the plate; expected a larger "
                      "plate, or a smaller or slower impactor");
    // one of few, so that similar impactors share their load; what that changes
    // of the radius, half a per cent at most, is a ten thousandth of the force
    // of the steel case
    const double steps =
      std::lround(64. * std::log2(radius / plate.thickness)) / 64.;
    choose("Contact/Patch radius",
           contact.patch_radius,
           plate.thickness * std::exp2(steps));
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
    // the singular points that the scene names are where the mesh has them
    auto               &points   = adaptivity.singular_points.points;
    const PlateGeometry geometry = geometry_of(plate);
    const auto          mesh     = points.empty() ?
                   nullptr :
                   make_plate_mesh(plate, discretization.initial_cells);
    for (SingularPoint &point : points)
      {
        const auto [x, y] = point.position;
        point.position    = {{x * std::cos(turn) + y * std::sin(turn),
                              y * std::cos(turn) - x * std::sin(turn)}};
        for (const unsigned int d : {0, 1})
          {
            point.position[d] -= plate.impact_point[d];
            if (geometry.is_symmetric[d])
              point.position[d] = std::abs(point.position[d]);
          }
        bool is_on_plate = false;
        for (const auto &cell : mesh->active_cell_iterators())
          is_on_plate |= touches_point(cell, point.position);
        if (!is_on_plate)
          refuse({"Adaptivity/Singular points", "Plate/Outline"},
                 "names the point " + number(x) + " m, " + number(y) +
                   " m, which is not on the plate; expected coordinates from "
                   "its centre");
      }
    if (adaptivity.maximum_cell_size == 0.)
      choose("Adaptivity/Maximum cell size",
             adaptivity.maximum_cell_size,
             initial_cell_size(*this));
    adaptivity.minimum_cell_size_is_chosen = adaptivity.minimum_cell_size == 0.;
    if (adaptivity.minimum_cell_size_is_chosen)
      choose("Adaptivity/Minimum cell size",
             adaptivity.minimum_cell_size,
             0.25 *
               (contact.has_patch() ? contact.patch_radius : plate.thickness));
  }
} // namespace PlateImpact
