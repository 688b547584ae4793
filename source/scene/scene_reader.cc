#include "plate_impact/scene/scene_reader.h"

#include "plate_impact/base/exceptions.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <regex>
#include <system_error>
#include <utility>

namespace PlateImpact
{
  namespace fs = std::filesystem;

  namespace
  {
    bool
    has_section(const Entries &entries, const std::string &section)
    {
      for (const Entry &entry : entries.all)
        if (entry.section() == section)
          return true;
      return false;
    }



    /// Units of entries, and what one that people write is in them.
    const std::map<std::string, std::map<std::string, double>> units = {
      {"m", {{"m", 1.}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}}},
      {"s", {{"s", 1.}, {"ms", 1e-3}, {"us", 1e-6}}},
      {"kg", {{"kg", 1.}, {"g", 1e-3}, {"t", 1e3}}},
      {"m/s", {{"m/s", 1.}, {"mm/s", 1e-3}, {"km/h", 1. / 3.6}}},
      {"Pa",
       {{"Pa", 1.}, {"kPa", 1e3}, {"MPa", 1e6}, {"N/mm^2", 1e6}, {"GPa", 1e9}}},
      {"kg/m^3",
       {{"kg/m^3", 1.}, {"kg/m3", 1.}, {"g/cm^3", 1e3}, {"g/cm3", 1e3}}},
      {"N", {{"N", 1.}, {"kN", 1e3}}},
      {"-", {{"%", 1e-2}}}};

    /// Words of scenes, and others for them.
    const std::vector<std::pair<std::string, std::vector<std::string>>>
      synonyms = {
        {"clamped",
         {"fixed", "built-in", "built in", "encastre", "fully fixed"}},
        {"simply supported", {"hinged", "pinned"}},
        {"sphere", {"ball"}},
        {"cylinder", {"roller"}},
        {"circle", {"circular", "disc"}},
        {"rectangle", {"rectangular", "square"}},
        {"true", {"yes", "on"}},
        {"false", {"no", "off"}}};



    /// A number with a unit after it, or a list of them, in the unit of the
    /// entry.
    std::string
    converted(const std::string &value, const std::string &unit)
    {
      static const std::regex number_and_unit(
        R"(([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([A-Za-z%][A-Za-z0-9/^]*))");
      const auto  of_entry = units.find(unit);
      std::string all;
      for (const std::string &item : split_list(value))
        {
          std::smatch parts;
          double      number = 0.;
          if (of_entry == units.end() ||
              !std::regex_match(item, parts, number_and_unit) ||
              of_entry->second.count(parts[2]) == 0 ||
              !to_number(parts[1].str(), number) ||
              !std::isfinite(number *= of_entry->second.at(parts[2])))
            return {};
          all += (all.empty() ? "" : ", ") + fmt::format("{:.6g}", number);
        }
      return all;
    }



    /// What to write in place of a value that an entry does not allow: a number
    /// with a unit in that of the entry ("8 mm": "; write 0.008"), a decimal
    /// comma as a point, another word for one that is allowed ("fixed": "; did
    /// you mean 'clamped'?"). Empty where nothing comes to mind.
    std::string
    hint_for(const std::string &value, const Entry &entry)
    {
      // regular expressions need stack for every character
      if (value.size() > 1000)
        return {};
      const std::string unit = entry.unit();
      if (const std::string number = converted(value, unit); !number.empty())
        return "; write " + number + (unit == "-" ? "" : ", in " + unit);
      static const std::regex decimal_comma(R"([-+]?[0-9]+,[0-9]+)");
      if (std::regex_match(value, decimal_comma) &&
          entry.allowed.rfind("a number", 0) == 0)
        return "; write " +
          boost::algorithm::replace_all_copy(value, ",", ".") +
          ", with a point";
      for (const auto &[word, others] : synonyms)
        if (std::count(others.begin(), others.end(), value) > 0 &&
            entry.allowed.find(word) != std::string::npos)
          return "; did you mean '" + word + "'?";
      return {};
    }
  } // namespace



  std::string
  SceneReader::unknown(const std::string &section,
                       const std::string &name) const
  {
    // the closest of the names, or all of them
    const auto hint = [](const std::string              &misspelled,
                         const std::vector<std::string> &names) {
      const std::string closest = closest_name(misspelled, names);
      return closest.empty() ?
        fmt::format("; expected {}", fmt::join(names, ", ")) :
        "; did you mean '" + closest + "'?";
    };
    std::vector<std::string> sections, names;
    std::string              elsewhere;
    for (const Entry &entry : entries.all)
      {
        if (sections.empty() || sections.back() != entry.section())
          sections.push_back(entry.section());
        if (entry.section() == section)
          names.push_back(entry.name());
        else if (entry.name() == name)
          elsewhere += (elsewhere.empty() ? "" : " or ") + entry.section();
      }
    if (names.empty())
      return "there is no section '" + section + "'" + hint(section, sections);
    return "there is no entry '" + name + "' in section " + section +
      (!elsewhere.empty() && closest_name(name, names).empty() ?
         "; it belongs to section " + elsewhere :
         hint(name, names));
  }



  SceneReader::SceneReader(const std::string                &path,
                           const std::vector<std::string>   &overrides,
                           const std::optional<std::string> &output)
    : SceneReader(path)
  {
    std::ifstream   in(path);
    std::error_code error;
    SceneFile       file = scan_scene(in, path);
    mistakes             = file.mistakes;
    if (!in.is_open() || in.bad())
      mistakes = {path +
                  (fs::exists(path, error) ? ": the scene cannot be read" :
                                             ": there is no such scene")};

    // what the command line changes comes after the file
    const auto add = [&file](const Assignment &assignment) {
      file.assignments.push_back(assignment);
      file.sections.push_back(assignment);
    };
    for (const std::string &text : overrides)
      try
        {
          add(parse_override(text));
        }
      catch (const InputError &mistake)
        {
          mistakes.push_back(mistake.what());
        }
    if (output)
      add({"Output", "Directory", *output, "--output"});
    for (const Assignment &opening : file.sections)
      if (!has_section(entries, opening.section))
        mistakes.push_back(opening.origin + ": " +
                           unknown(opening.section, opening.entry));
    set(file.assignments);
    // the results must not replace the scene
    const Entry &directory = entries.at("Output/Directory");
    if (fs::equivalent(name, fs::path(directory.value) / "scene.prm", error))
      refuse(
        directory,
        "holds the scene itself, which the results would replace; expected "
        "another directory or file name");
  }



  void
  SceneReader::set(const std::vector<Assignment> &assignments)
  {
    for (const Assignment &assignment : assignments)
      {
        if (!has_section(entries, assignment.section))
          continue;
        const std::string path    = assignment.path(),
                          refusal = assignment.origin + ": " + path + " = ";
        std::string     value     = assignment.value;
        const fs::path  beside    = fs::path(name).parent_path() / value;
        std::error_code error;
        if (path == "Plate/Outline" && beside.extension() == ".msh" &&
            fs::is_regular_file(beside, error))
          value = beside.string();

        Entry *const entry = entries.find(path);
        if (entry == nullptr)
          mistakes.push_back(assignment.origin + ": " +
                             unknown(assignment.section, assignment.entry));
        else if (!can_be_set(value))
          mistakes.push_back(refusal + value +
                             " contains a character that is not allowed in a "
                             "scene: '#' or a control character");
        else if (!entry->set(value, assignment.origin))
          mistakes.push_back(refusal + (value.empty() ? "(nothing)" : value) +
                             " is not allowed; expected " + entry->allowed +
                             hint_for(value, *entry));
      }
  }



  void
  SceneReader::refuse_mistakes()
  {
    if (mistakes.empty())
      return;
    // those without a line come after the others
    const auto line = [this](const std::string &mistake) {
      return mistake.compare(0, name.size() + 1, name + ":") == 0 ?
        std::strtoul(mistake.c_str() + name.size() + 1, nullptr, 10) :
        std::numeric_limits<unsigned long>::max();
    };
    std::stable_sort(mistakes.begin(),
                     mistakes.end(),
                     [&line](const std::string &a, const std::string &b) {
                       return line(a) < line(b);
                     });
    throw InputError(mistakes);
  }



  // The entries of Output and Comparison. They are not declared in output/ and
  // comparison/, because those folders read scenes and so come after this one.

  void
  OutputParameters::declare_entries(Entries &entries)
  {
    const auto entry = entries.section("Output");
    entry("Directory",
          "output",
          any_text("the name of a directory, without '#' and line ends",
                   /*may_be_empty=*/false),
          directory)
      .means("Created where it does not exist.");
    entry("Write meshes", "true", truth(), write_meshes)
      .means("SVG, one per cycle.");
    entry("Write report", "true", truth(), write_report)
      .means("report.html: the run on one page.");
    entry("Field samples", "0", whole_number(0, 100000), field_samples)
      .means("VTU snapshots over the last cycle; 0: none.");
    entry("Natural frequencies", "0", whole_number(0, 100), natural_frequencies)
      .means("How many of the lowest natural frequencies of the last mesh are "
             "written to summary.json. Only modes with the symmetry of the "
             "impact are counted, since it excites no others.");
  }



  void
  ComparisonParameters::declare_entries(Entries &entries)
  {
    const auto entry = entries.section("Comparison");
    entry("Strategies",
          "uniform, hanging nodes, remeshing",
          list(one_of<ComparedStrategy>(),
               1,
               Choices<ComparedStrategy>::words.size()),
          strategies)
      .means("This section is read by `plate-impact compare` only. The "
             "strategies to compare, each with every element. They adapt the "
             "mesh for the error in the energy norm; those whose name ends in "
             "'by force' adapt it for the error of the peak force "
             "(Adaptivity/Goal).");
    entry("Elements",
          "serendipity, heterosis, Lagrange, MITC9",
          list(one_of<ElementType>(), 1, Choices<ElementType>::words.size()),
          elements)
      .means("As in Discretization/Element.");
    entry("Maximum cycles", "6", whole_number(1, 1000), maximum_cycles)
      .means("Meshes of a curve, the initial one included. Adaptivity/Target "
             "error is halved whenever it is met.");
    entry("Reference peak force", "0", number_from(0), reference_peak_force)
      .means("What errors are relative to; 0: computed by a run much finer "
             "than any in the comparison. [N]");
    entry("Time budget", "60", number_above(0), time_budget)
      .means("Computing time after which a curve is not continued. The time of "
             "the reference does not count. [s]");
  }
} // namespace PlateImpact
