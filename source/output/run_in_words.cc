#include "plate_impact/output/run_in_words.h"

#include "plate_impact/base/text.h"
#include "plate_impact/contact/contact_law.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  namespace
  {
    using Json = nlohmann::ordered_json;



    /// Peak force and contact time of an infinite thin plate, beside ours.
    Fact
    zener_fact(const Parameters &parameters, const double peak_force)
    {
      const ExpectedPeak expected =
        zener_peak(*make_half_space_law(parameters),
                   make_impactor(parameters.impactor),
                   PlateSection(parameters.plate));
      const double deviation = peak_force / expected.force - 1.;
      return {"Zener's infinite thin plate",
              number(expected.force, "N"),
              "at " + number(expected.time, "s") +
                (parameters.impactor.is_cylinder() ?
                   ", struck at a point: a lower bound for a cylinder; ours: " :
                   "; ours: ") +
                fmt::format("{:+.2f} %", 100. * deviation)};
    }
  } // namespace



  std::string
  scene_in_words(const Parameters &parameters)
  {
    const PlateParameters &plate = parameters.plate;
    const PrefixedUnit     side("m",
                            std::max(plate.side_lengths[0],
                                     plate.side_lengths[1])),
      thickness("m", plate.thickness);
    std::string support = word_for(plate.support.front());
    if (plate.support.size() > 1 && plate.support[1] != plate.support[0])
      support += " (x edges) and " + word_for(plate.support[1]) + " (y edges)";
    const std::string target = "plate of " +
      number(side(plate.side_lengths[0])) + " × " +
      side.text(plate.side_lengths[1]) + ", " +
      thickness.text(plate.thickness) + " thick, " + support;
    if (!parameters.has_impactor())
      return "A " + target + ". Nothing strikes it.";

    const ImpactorParameters &impactor = parameters.impactor;
    // masses in grams below one kilogram
    return "A " + word_for(impactor.shape) + " of radius " +
      number(impactor.radius, "m") + " and mass " +
      number(1e3 * impactor.mass, "g") + " strikes the middle of a " + target +
      ", at " + number(impactor.velocity, "m/s") + ".";
  }



  std::string
  local_response_in_words(const Parameters &parameters)
  {
    const ContactParameters &contact = parameters.contact;
    if (contact.local_response == LocalResponse::layer)
      return "layer, as three-dimensional elasticity has it";
    std::string text = "half-space, beside the plate's own shear: the shortest "
                       "waves count twice and the force is too small";
    if (contact.law == ForceLaw::Sun)
      text += "; the law Sun has no other";
    else if (!contact.has_patch())
      text +=
        "; a " + word_for(contact.load_distribution) + " load has no other";
    return text;
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
           number(value("peak_force")) + " N" +
             (bar > 0. ? " ± " + about(bar * value("peak_force")) + " N" : ""),
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
      facts.push_back({"Relative error in the energy norm η",
                       percentage(value("discretization_error")),
                       "target " +
                         percentage(parameters.adaptivity.target_error) +
                         "; largest ξ′ " + number(value("max_element_error"))});
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
          "; the peak force is usually far more accurate.";
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
           " by the dual problem, with a factor of safety of 2"});
    else if (last.contains("peak_force_error_estimate"))
      table.rows.push_back(
        {"Mesh: error of the peak force",
         "not known: the mesh is too coarse to tell it, or the time step to "
         "tell its own"});
    if (cycles.size() > 1)
      {
        const double before = cycles[cycles.size() - 2]["peak_force"];
        const double change = last["peak_force"].get<double>() / before - 1.;
        table.rows.push_back(
          {"Mesh: change in the last cycle",
           percentage(change) + " (from " + number(before) + " N)"});
      }
    table.rows.push_back(
      {"Time step",
       number(parameters.time.time_step, "s") + ", " + number(last["steps"]) +
         " steps" +
         (last.contains("time_error") ? "; estimated error of the peak force " +
              percentage(last["time_error"]) :
                                        "") +
         "; energy drift " + number(last["relative_energy_drift"]) +
         (last.contains("first_contact_end") ? "; " +
              std::to_string(std::lround(
                last["first_contact_end"].get<double>() /
                parameters.time.time_step)) +
              " of the steps in the first contact" :
                                               "")});
    const ContactParameters &contact = parameters.contact;
    table.rows.push_back(
      {"Local response under the contact",
       local_response_in_words(parameters) + "; contact radius " +
         number(last["contact_radius_over_thickness"]) + " of the thickness"});
    std::string load_text = word_for(contact.load_distribution);
    if (contact.load_is_singular())
      load_text += ": the peak force has no limit under refinement";
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
