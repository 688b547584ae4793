#include "plate_impact/output/run_in_words.h"

#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace PlateImpact
{
  namespace
  {
    using Json = nlohmann::ordered_json;



    /// Peak force and contact time of an infinite thin plate, beside ours.
    Fact
    zener_fact(const Parameters &parameters, const double peak_force)
    {
      const ExpectedPeak expected = zener_peak(parameters);
      return {"Zener's infinite thin plate",
              number(expected.force, "N"),
              "at " + number(expected.time, "s") +
                (parameters.impactor.is_cylinder() ?
                   ", struck at a point: a lower bound for a cylinder; ours: " :
                   "; ours: ") +
                deviation(peak_force, expected.force)};
    }
  } // namespace



  namespace
  {
    std::string
    place_in_words(const PlateParameters &plate)
    {
      const auto &point = plate.impact_point;
      if (point[0] == 0. && point[1] == 0.)
        return "the middle of";
      if (plate.is_circle())
        return about(std::hypot(point[0], point[1]), "m") +
          " from the middle of";
      const PrefixedUnit unit("m",
                              std::max(std::abs(point[0]), std::abs(point[1])));
      return number(unit(point[0])) + " and " + unit.text(point[1]) +
        ", along x and y, from the middle of";
    }
  } // namespace



  namespace
  {
    std::string
    supports_in_words(const PlateParameters &plate)
    {
      const auto &supports = plate.supports;
      if (supports.front().edge.empty())
        return word_for(supports.front().support) +
          (supports.back().support == supports.front().support ?
             "" :
             " (x edges) and " + word_for(supports.back().support) +
               " (y edges)");
      std::string text;
      for (const auto &[edge, support] : supports)
        text +=
          (text.empty() ? "" : ", ") + word_for(support) + " (" + edge + ")";
      return text;
    }
  } // namespace



  std::string
  scene_in_words(const Parameters &parameters)
  {
    const PlateParameters &plate    = parameters.plate;
    const auto             geometry = geometry_of(plate);
    const PrefixedUnit     side("m",
                            std::max(geometry->side_length(0),
                                     geometry->side_length(1))),
      thickness("m", plate.thickness);
    const std::string extent = plate.is_circle() ?
      "round plate of " + side.text(plate.side_lengths[0]) + " diameter, " :
      (plate.is_from_file() ? "plate (" +
           std::filesystem::path(plate.outline.file).filename().string() +
           ") of " :
                              "plate of ") +
        number(side(geometry->side_length(0))) + " × " +
        side.text(geometry->side_length(1)) + ", ";
    const std::string target = extent + thickness.text(plate.thickness) +
      " thick, " +
      (plate.is_laminate() ? "plies " + plate.layup.text + ", " : "") +
      supports_in_words(plate);
    if (!parameters.has_impactor())
      return "A " + target + ". Nothing strikes it.";

    const ImpactorParameters &impactor = parameters.impactor;
    // masses in grams below one kilogram
    return "A " + word_for(impactor.shape) + " of radius " +
      number(impactor.radius, "m") + " and mass " +
      number(1e3 * make_impactor(impactor).mass, "g") + " strikes " +
      place_in_words(plate) + " a " + target + ", at " +
      number(impactor.velocity, "m/s") + ".";
  }



  std::string
  local_response_in_words(const Parameters &parameters)
  {
    const ContactParameters &contact = parameters.contact;
    if (contact.local_response == LocalResponse::layer)
      return "layer, as three-dimensional elasticity has it";
    if (parameters.plate.is_laminate())
      return "half-space, as a laminate has no other; how far it is right is "
             "not known";
    // the shear of a homogeneous plate has a factor of 5/6
    if (parameters.plate.shear_correction_factor > 10.)
      return "half-space, beside a plate without shear";
    std::string text = "half-space, beside the plate's own shear: the shortest "
                       "waves count twice and the force is too small";
    if (contact.unloading != UnloadingLaw::elastic)
      text += "; a contact that leaves a dent has no other";
    else if (contact.law == ForceLaw::Sun)
      text += "; the law Sun has no other";
    else if (!contact.has_patch())
      text +=
        "; a " + word_for(contact.load_distribution) + " load has no other";
    return text;
  }



  std::vector<std::string>
  stresses_in_words(const PlateSection &section)
  {
    if (section.stress_names().size() == 1)
      return {"von Mises stress at the faces"};
    return {"largest stress along fibres",
            "largest stress across fibres",
            "largest shear stress of plies"};
  }



  std::vector<Fact>
  facts_of_run(const Parameters &parameters, const Json &summary)
  {
    const Json       &last = summary["cycles"].back();
    std::vector<Fact> facts;
    const auto        value = [&last](const char *key) {
      return last[key].get<double>();
    };
    if (last.contains("peak_force"))
      {
        const double bar = last.value("peak_force_error_bar", 0.);
        facts.push_back(
          {"Peak force",
           with_error(value("peak_force"), bar * value("peak_force"), "N"),
           "at " + number(value("time_of_peak_force"), "s") +
             (bar > 0. ? "; by mesh and time step, not by what "
                         "the model leaves out" :
                         "")});
        facts.push_back(zener_fact(parameters, value("peak_force")));
        if (last.contains("first_contact_end"))
          facts.push_back({"First contact ends",
                           number(value("first_contact_end"), "s"),
                           "contacts: " + number(value("number_of_contacts"))});
        facts.push_back({"Impactor at the end",
                         number(value("final_impactor_velocity"), "m/s"),
                         "positive towards the plate; impulse " +
                           number(value("impulse"), "N s")});
        facts.push_back({"Largest displacement under the load",
                         number(value("max_plate_displacement"), "m"),
                         "at the peak force " +
                           number(value("plate_displacement_at_peak"), "m")});
        if (last.contains("max_fibre_stress"))
          facts.push_back(
            {"Largest stresses of the plies",
             number(value("max_fibre_stress"), "Pa"),
             "along the fibres, " +
               number(value("max_transverse_stress"), "Pa") +
               " across them and " +
               number(value("max_ply_shear_stress"), "Pa") +
               " in shear, at the faces of the plies, of plate theory under "
               "the spread load"});
        if (last.contains("dissipated_energy"))
          facts.push_back({"Energy dissipated by the contact",
                           number(value("dissipated_energy"), "J"),
                           "which leaves a dent of " +
                             number(value("permanent_indentation"), "m")});
        if (last.contains("max_effective_stress") &&
            last.contains("contact_pressure"))
          facts.push_back(
            {"Largest stress of the plate",
             number(value("max_effective_stress"), "Pa"),
             "von Mises, at the faces, of plate theory under the spread load; "
             "not that of the contact, whose pressure reaches " +
               number(value("contact_pressure"), "Pa")});
      }
    if (last.contains("discretization_error"))
      facts.push_back(
        {"Relative error in the energy norm η",
         percentage(value("discretization_error")),
         "target " + percentage(parameters.adaptivity.target_error) +
           "; largest ξ′ " + rounded(value("max_element_error"))});
    facts.push_back({"Outcome",
                     summary["outcome"].get<std::string>(),
                     "cycles: " + std::to_string(summary["cycles"].size()) +
                       ", cells: " + number(value("cells")) +
                       ", unknowns: " + number(value("degrees_of_freedom"))});
    return facts;
  }



  Table
  evidence_of_run(const Parameters &parameters, const Json &summary)
  {
    const Json &cycles = summary["cycles"];
    const Json &last   = cycles.back();
    Table       table{{"What the peak force depends on", "Evidence"}, {}, true};
    if (last.contains("discretization_error"))
      {
        std::string text = "η = " + percentage(last["discretization_error"]) +
          " in the energy norm, target " +
          percentage(parameters.adaptivity.target_error) +
          "; what that means for the peak force is the next row.";
        if (last.contains("singular_cells"))
          text += " Without " + number(last["singular_cells"]) +
            " cells at the point load; with them " +
            percentage(last["discretization_error_of_all_cells"]) + ".";
        table.rows.push_back({"Mesh: estimated error", text});
      }
    if (last.contains("peak_force_error_bar"))
      table.rows.push_back(
        {"Mesh: error of the peak force",
         about_percentage(last["peak_force_error_space"]) +
           " by the dual problem, with a factor of safety of " +
           about(safety_of_bar)});
    else if (last.contains("peak_force_error_estimate"))
      table.rows.push_back(
        {"Mesh: error of the peak force",
         "not known: the mesh is too coarse to tell it, or the time step to "
         "tell its own"});
    if (last.contains("verification"))
      table.rows.push_back(
        {"Mesh: every cell halved",
         deviation(last["verification"]["peak_force"], last["peak_force"]) +
           " (to " + number(last["verification"]["peak_force"], "N") + " on " +
           counted(last["verification"]["cells"], "cell") + ")"});
    if (cycles.size() > 1)
      {
        const double before = cycles[cycles.size() - 2]["peak_force"];
        table.rows.push_back({"Mesh: change in the last cycle",
                              deviation(last["peak_force"], before) +
                                " (from " + number(before, "N") + ")"});
      }
    table.rows.push_back(
      {"Time step",
       number(last["time_step"], "s") + ", " + number(last["steps"]) +
         " steps" +
         (last.contains("time_error") ? "; estimated error of the peak force " +
              percentage(last["time_error"]) :
                                        "") +
         "; energy drift " + rounded(last["relative_energy_drift"]) +
         (last.contains("first_contact_end") ? "; " +
              std::to_string(std::lround(
                last["first_contact_end"].get<double>() /
                last["time_step"].get<double>())) +
              " of the steps in the first contact" :
                                               "")});
    const ContactParameters &contact = parameters.contact;
    table.rows.push_back(
      {"Local response under the contact",
       local_response_in_words(parameters) + "; contact radius " +
         rounded(last["contact_radius_over_thickness"]) + " of the thickness"});
    std::string load_text = word_for(contact.load_distribution);
    if (contact.load_is_singular())
      load_text += parameters.plate.shear_correction_factor > 10. ?
        "; a plate without shear has a limit under it" :
        ": the peak force has no limit under refinement";
    else if (contact.has_patch())
      load_text +=
        (contact.load_has_length() ? " of half-width " : " of radius ") +
        number(contact.patch_radius, "m");
    const double cell = last["min_cell_size"];
    table.rows.push_back(
      {"Load", load_text + "; smallest cell " + number(cell, "m")});
    return table;
  }
} // namespace PlateImpact
