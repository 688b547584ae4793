#include "plate_impact/scene.h"

#include "plate_impact/contact_law.h"
#include "plate_impact/exceptions.h"
#include "plate_impact/impactor.h"
#include "plate_impact/plate_section.h"
#include "plate_impact/scene_schema.h"
#include "plate_impact/zener.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace PlateImpact
{
  namespace
  {
    /// The schema of a scene bound to the parameters that it fills.
    struct BoundSchema
    {
      Parameters               parameters;
      std::vector<std::string> unread;
      SceneSchema              schema;

      BoundSchema()
      {
        declare_parameters(schema, parameters, unread);
      }
    };



    /// The sentence of a mistake in the value of an entry.
    std::string
    mistake(const SceneSchema &schema,
            const std::string &path,
            const std::string &text)
    {
      return schema.origin(path) + ": " + path + " = " + schema.value(path) +
        " " + text;
    }



    /// Entries of the interface that this version cannot honour.
    std::vector<std::string>
    check_availability(const SceneSchema &schema)
    {
      std::vector<std::string>                               mistakes;
      const std::vector<std::pair<std::string, std::string>> unavailable = {
        {"Impactor/Shape", "cylinder"},
        {"Contact/Law", "line"},
        {"Contact/Load distribution", "line"},
        {"Contact/Load distribution", "strip"},
        {"Discretization/Element", "MITC9"},
        {"Time/Integrator", "Ritz vectors"},
        {"Adaptivity/Strategy", "remeshing"}};
      for (const auto &[path, value] : unavailable)
        if (schema.value(path) == value)
          mistakes.push_back(mistake(schema, path, "is not available yet"));
      for (const std::string section : {"Comparison", "Sweep"})
        for (const std::string &path : schema.entries_of(section))
          if (schema.is_changed(path))
            mistakes.push_back(mistake(schema, path, "is not available yet"));
      return mistakes;
    }



    /// Checks across entries.
    std::vector<std::string>
    check_together(const SceneSchema &schema, const Parameters &parameters)
    {
      std::vector<std::string> mistakes;
      const auto               refuse = [&](const std::string &path,
                              const std::string &text) {
        mistakes.push_back(mistake(schema, path, text));
      };
      const auto in_words = [](const double value) {
        std::ostringstream text;
        text << value;
        return text.str();
      };

      const PlateParameters &plate = parameters.plate;
      const double           shorter_side =
        std::min(plate.side_lengths[0], plate.side_lengths[1]);
      if (plate.thickness > 0.5 * shorter_side)
        refuse("Plate/Thickness",
               "m is too thick for a plate theory; expected at most half the "
               "shorter side, " +
                 in_words(0.5 * shorter_side) + " m");
      if (parameters.contact.load_distribution != "point" &&
          parameters.contact.patch_radius > 0.5 * shorter_side)
        refuse("Contact/Patch radius",
               "m reaches beyond the plate; expected at most half the shorter "
               "side, " +
                 in_words(0.5 * shorter_side) + " m");

      const TimeParameters &time = parameters.time;
      if (time.time_step > time.end_time)
        refuse("Time/Time step",
               "s is longer than End time, " + in_words(time.end_time) + " s");
      else if (time.end_time / time.time_step > 1e8)
        refuse("Time/Time step",
               "s needs more than 1e8 steps to reach End time, " +
                 in_words(time.end_time) + " s");
      if (time.newmark_beta < 0.5 * time.newmark_gamma)
        refuse("Time/Newmark beta",
               "is below half of Newmark gamma, so that the scheme is unstable "
               "on fine meshes; expected at least " +
                 in_words(0.5 * time.newmark_gamma));
      if (parameters.contact.integration == "energy conserving" &&
          (time.newmark_beta != 0.25 || time.newmark_gamma != 0.5))
        refuse("Contact/Integration",
               "needs Newmark beta = 0.25 and Newmark gamma = 0.5, which alone "
               "conserve energy; with others set Integration = collocation");

      const auto &cells = parameters.discretization.initial_cells;
      if (static_cast<double>(cells[0]) * cells[1] > 1e6)
        refuse("Discretization/Initial cells", "are more than a million cells");
      const double h = 0.5 *
        std::max(plate.side_lengths[0] / cells[0],
                 plate.side_lengths[1] / cells[1]);
      if (parameters.adaptivity.minimum_cell_size > h)
        refuse("Adaptivity/Minimum cell size",
               "m is larger than the initial cells, " + in_words(h) + " m");
      return mistakes;
    }



    /// Replaces zeros that mean "chosen by the program".
    /// @return a sentence when what is chosen does not fit the plate
    std::vector<std::string>
    complete(SceneSchema &schema, Parameters &parameters)
    {
      if (!parameters.has_impactor())
        return {};
      const Impactor impactor = make_impactor(parameters.impactor);
      if (parameters.impactor.mass == 0.)
        schema.set("Impactor", "Mass", impactor.mass);

      const bool at_point = parameters.contact.load_distribution == "point";
      if (!at_point && parameters.contact.patch_radius == 0.)
        {
          const ExpectedPeak peak = zener_peak(*make_contact_law(parameters),
                                               impactor,
                                               PlateSection(parameters.plate));
          const double       radius =
            std::sqrt(parameters.impactor.radius * peak.indentation);
          const auto &sides = parameters.plate.side_lengths;
          if (radius > 0.5 * std::min(sides[0], sides[1]))
            return {mistake(schema,
                            "Contact/Patch radius",
                            "lets the program choose the Hertz contact radius, "
                            "but that is " +
                              std::to_string(radius) +
                              " m and reaches beyond the plate")};
          schema.set("Contact", "Patch radius", radius);
        }
      if (parameters.adaptivity.minimum_cell_size == 0.)
        schema.set("Adaptivity",
                   "Minimum cell size",
                   0.25 *
                     (at_point ? parameters.plate.thickness
                               : parameters.contact.patch_radius));
      return {};
    }
  } // namespace



  Scene
  read_scene(const std::string &path, const std::vector<std::string> &overrides)
  {
    std::ifstream in(path);
    SceneFile     file;
    if (in.is_open())
      file = scan_scene(in, path);
    if (!in.is_open() || in.bad())
      throw InputError({path + ": the scene cannot be read"});
    for (const std::string &override_text : overrides)
      {
        file.assignments.push_back(parse_override(override_text));
        file.sections.push_back(file.assignments.back());
      }

    BoundSchema              bound;
    SceneSchema             &schema   = bound.schema;
    std::vector<std::string> mistakes = file.mistakes;
    const auto add = [&mistakes](const std::vector<std::string> &more) {
      mistakes.insert(mistakes.end(), more.begin(), more.end());
    };
    add(schema.check_sections(file.sections));
    add(schema.set(file.assignments));
    add(check_availability(schema));
    add(check_together(schema, bound.parameters));
    if (mistakes.empty())
      add(complete(schema, bound.parameters));
    if (!mistakes.empty())
      throw InputError(mistakes);

    std::ostringstream text;
    schema.print(text, /*with_documentation=*/false);
    return {path, bound.parameters, text.str()};
  }



  void
  print_defaults(std::ostream &out)
  {
    BoundSchema().schema.print(out, /*with_documentation=*/true);
  }
} // namespace PlateImpact
