#include "plate_impact/scene/scene_reader.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/scene/declarations.h"
#include "plate_impact/scene/scene_file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace PlateImpact
{
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
  } // namespace



  SceneReader::SceneReader()
  {
    declare_parameters(schema, bound);
  }



  SceneReader::SceneReader(const std::string                &path,
                           const std::vector<std::string>   &overrides,
                           const std::optional<std::string> &output)
    : name(path)
  {
    declare_parameters(schema, bound);
    SceneFile file = scan(path, overrides, output);
    for (Assignment &assignment : file.assignments)
      locate(assignment);
    mistakes = file.mistakes;
    add_mistakes(schema.check_sections(file.sections));
    add_mistakes(schema.set(file.assignments));
    check_directory();
  }



  void
  SceneReader::locate(Assignment &assignment) const
  {
    namespace fs = std::filesystem;
    if (assignment.path() != "Plate/Outline" ||
        fs::path(assignment.value).extension() != ".msh")
      return;
    const fs::path  beside = fs::path(name).parent_path() / assignment.value;
    std::error_code error;
    if (fs::is_regular_file(beside, error))
      assignment.value = beside.string();
  }



  void
  SceneReader::add_mistakes(const std::vector<std::string> &more)
  {
    mistakes.insert(mistakes.end(), more.begin(), more.end());
  }



  void
  SceneReader::check_directory()
  {
    const std::filesystem::path written =
      std::filesystem::path(bound.output.directory) / "scene.prm";
    std::error_code error;
    if (std::filesystem::equivalent(name, written, error))
      mistakes.push_back(
        schema.origin("Output/Directory") +
        ": Output/Directory = " + schema.value("Output/Directory") +
        " holds the scene itself, which the results would "
        "replace; expected another directory or file name");
  }



  void
  SceneReader::refuse_mistakes()
  {
    if (mistakes.empty())
      return;
    sort_by_line(mistakes, name);
    throw InputError(mistakes);
  }



  Parameters
  SceneReader::parameters() const
  {
    return bound;
  }



  std::string
  SceneReader::text() const
  {
    std::ostringstream out;
    schema.print(out, /*with_documentation=*/false);
    return out.str();
  }
} // namespace PlateImpact
