#include "plate_impact/scene/scene_reader.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/scene/value_hint.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

namespace PlateImpact
{
  namespace fs = std::filesystem;

  namespace
  {
    /// Mistakes in the order of the lines of the file; others after them.
    void
    sort_by_line(std::vector<std::string> &mistakes, const std::string &file)
    {
      const auto line = [&file](const std::string &mistake) {
        return mistake.compare(0, file.size() + 1, file + ":") == 0 ?
          std::strtoul(mistake.c_str() + file.size() + 1, nullptr, 10) :
          std::numeric_limits<unsigned long>::max();
      };
      std::stable_sort(mistakes.begin(),
                       mistakes.end(),
                       [&line](const std::string &a, const std::string &b) {
                         return line(a) < line(b);
                       });
    }



    /// The file taken apart, with the changes of the command line after it.
    SceneFile
    scan(const std::string                &path,
         const std::vector<std::string>   &overrides,
         const std::optional<std::string> &output)
    {
      std::ifstream in(path);
      SceneFile     file;
      if (in.is_open())
        file = scan_scene(in, path);
      if (!in.is_open() || in.bad())
        file.mistakes = {path + ": the scene cannot be read"};

      const auto add = [&file](const Assignment &assignment) {
        file.assignments.push_back(assignment);
        file.sections.push_back(assignment);
      };
      for (const std::string &text : overrides)
        try
          {
            add(parse_override(text));
          }
        catch (const InputError &error)
          {
            file.mistakes.push_back(error.what());
          }
      if (output)
        add({"Output", "Directory", *output, "--output"});
      return file;
    }



    bool
    has_section(const Entries &entries, const std::string &section)
    {
      return std::any_of(entries.all.begin(),
                         entries.all.end(),
                         [&section](const Entry &entry) {
                           return entry.section() == section;
                         });
    }



    /// "; did you mean ...?", empty when nothing is close.
    std::string
    suggestion(const std::string              &name,
               const std::vector<std::string> &candidates)
    {
      const std::string closest = closest_name(name, candidates);
      return closest.empty() ? "" : "; did you mean '" + closest + "'?";
    }
  } // namespace



  std::string
  unknown(const Entries     &entries,
          const std::string &section,
          const std::string &name)
  {
    std::vector<std::string> sections, names;
    std::string              elsewhere;
    for (const Entry &entry : entries.all)
      {
        sections.push_back(entry.section());
        if (entry.section() == section)
          names.push_back(entry.name());
        else if (entry.name() == name)
          elsewhere += (elsewhere.empty() ? "" : " or ") + entry.section();
      }
    if (names.empty())
      return "there is no section '" + section + "'" +
        suggestion(section, sections);
    const std::string hint = suggestion(name, names);
    return "there is no entry '" + name + "' in section " + section +
      (hint.empty() && !elsewhere.empty() ?
         "; it belongs to section " + elsewhere :
         hint);
  }



  SceneReader::SceneReader(const std::string &path)
    : name(path)
  {
    parameters.plate.declare_entries(entries);
    parameters.impactor.declare_entries(entries);
    parameters.contact.declare_entries(entries);
    parameters.discretization.declare_entries(entries);
    parameters.time.declare_entries(entries);
    parameters.adaptivity.declare_entries(entries);
    parameters.output.declare_entries(entries);
    parameters.comparison.declare_entries(entries);
    parameters.sweep.declare_entries(entries);
  }



  SceneReader::SceneReader(const std::string                &path,
                           const std::vector<std::string>   &overrides,
                           const std::optional<std::string> &output)
    : SceneReader(path)
  {
    const SceneFile file = scan(path, overrides, output);
    mistakes             = file.mistakes;
    for (const Assignment &opening : file.sections)
      if (!has_section(entries, opening.section))
        mistakes.push_back(opening.origin + ": " +
                           unknown(entries, opening.section, opening.entry));
    add_mistakes(set(file.assignments));
    // the results must not replace the scene
    const Entry    &directory = entries.at("Output/Directory");
    std::error_code error;
    if (fs::equivalent(name, fs::path(directory.value) / "scene.prm", error))
      mistakes.push_back(directory.origin + ": " + directory.path + " = " +
                         directory.value +
                         " holds the scene itself, which the results would "
                         "replace; expected another directory or file name");
  }



  std::vector<std::string>
  SceneReader::set(const std::vector<Assignment> &assignments)
  {
    std::vector<std::string> refused;
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

        if (entries.find(path) == nullptr)
          refused.push_back(
            assignment.origin + ": " +
            unknown(entries, assignment.section, assignment.entry));
        else if (!can_be_set(value))
          refused.push_back(refusal + value +
                            " holds a character that a scene cannot: '#' or a "
                            "control character");
        else if (!entries.at(path).set(value, assignment.origin))
          refused.push_back(refusal + (value.empty() ? "(nothing)" : value) +
                            " is not allowed; expected " +
                            entries.at(path).allowed +
                            hint_for(value, entries.at(path)));
      }
    return refused;
  }



  void
  SceneReader::add_mistakes(const std::vector<std::string> &more)
  {
    mistakes.insert(mistakes.end(), more.begin(), more.end());
  }



  void
  SceneReader::refuse_mistakes()
  {
    if (mistakes.empty())
      return;
    sort_by_line(mistakes, name);
    throw InputError(mistakes);
  }
} // namespace PlateImpact
