#include "plate_impact/scene/scene_schema.h"

#include "plate_impact/base/text.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// "; did you mean ...?", empty when nothing is close.
    std::string
    suggestion(const std::string              &name,
               const std::vector<std::string> &candidates)
    {
      const std::string closest = closest_name(name, candidates);
      return closest.empty() ? "" : "; did you mean '" + closest + "'?";
    }
  } // namespace



  void
  SceneSchema::begin_section(const std::string &name)
  {
    sections.push_back({name, {}});
  }



  void
  SceneSchema::choose(const std::string &section,
                      const std::string &entry,
                      const std::string &value)
  {
    given.try_emplace({section, entry}, this->value(section + '/' + entry));
    prm.enter_subsection(section);
    prm.set(entry, value);
    prm.leave_subsection();
  }



  void
  SceneSchema::take_back_choices()
  {
    for (const auto &[place, value] : given)
      {
        prm.enter_subsection(place.first);
        prm.set(place.second, value);
        prm.leave_subsection();
      }
    given.clear();
  }



  bool
  SceneSchema::has_section(const std::string &name) const
  {
    return std::any_of(sections.begin(),
                       sections.end(),
                       [&name](const auto &section) {
                         return section.first == name;
                       });
  }



  std::vector<std::string>
  SceneSchema::check_sections(const std::vector<Assignment> &openings) const
  {
    std::vector<std::string> mistakes;
    for (const Assignment &opening : openings)
      if (!has_section(opening.section))
        mistakes.push_back(opening.origin + ": " + unknown(opening));
    return mistakes;
  }



  std::vector<std::string>
  SceneSchema::set(const std::vector<Assignment> &assignments)
  {
    std::vector<std::string> mistakes;
    for (const Assignment &assignment : assignments)
      if (!has_section(assignment.section))
        continue;
      else if (const std::string mistake = set(assignment); !mistake.empty())
        mistakes.push_back(assignment.origin + ": " + mistake);
    return mistakes;
  }



  std::string
  SceneSchema::set(const Assignment &assignment)
  {
    const Entry *entry = find(assignment.section, assignment.entry);
    if (entry == nullptr)
      return unknown(assignment);

    // scene.prm has a line for an entry
    for (const char letter : assignment.value)
      if (letter == '#' ||
          (letter != '\t' && std::iscntrl(static_cast<unsigned char>(letter))))
        return assignment.path() + " = " + assignment.value +
          " holds a character that a scene cannot: '#' or a control character";
    prm.enter_subsection(assignment.section);
    std::string mistake;
    try
      {
        prm.set(assignment.entry, assignment.value);
        origins[assignment.path()] = assignment.origin;
        refused.erase(assignment.path());
      }
    catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
      {
        refused.insert(assignment.path());
        mistake = assignment.path() + " = " +
          (assignment.value.empty() ? "(nothing)" : assignment.value) +
          " is not allowed; expected " + entry->allowed.description();
      }
    prm.leave_subsection();
    return mistake;
  }



  std::string
  SceneSchema::unknown(const Assignment &assignment) const
  {
    std::vector<std::string> section_names, names;
    for (const auto &section : sections)
      section_names.push_back(section.first);
    if (!has_section(assignment.section))
      return "there is no section '" + assignment.section + "'" +
        suggestion(assignment.section, section_names);
    std::string elsewhere;
    for (const auto &[name, entries] : sections)
      for (const Entry &entry : entries)
        {
          if (name == assignment.section)
            names.push_back(entry.name);
          else if (entry.name == assignment.entry)
            elsewhere += (elsewhere.empty() ? "" : " or ") + name;
        }
    const std::string hint = suggestion(assignment.entry, names);
    return "there is no entry '" + assignment.entry + "' in section " +
      assignment.section +
      (hint.empty() && !elsewhere.empty() ?
         "; it belongs to section " + elsewhere :
         hint);
  }



  std::string
  SceneSchema::origin(const std::string &path) const
  {
    const auto set_at = origins.find(path);
    return set_at == origins.end() ? "default" : set_at->second;
  }



  bool
  SceneSchema::was_refused(const std::string &path) const
  {
    return refused.count(path) > 0;
  }



  std::string
  SceneSchema::value(const std::string &path) const
  {
    const std::size_t slash = path.find('/');
    return prm.get({path.substr(0, slash)}, path.substr(slash + 1));
  }



  bool
  SceneSchema::has_entry(const std::string &path) const
  {
    const std::size_t slash = path.find('/');
    return slash != std::string::npos &&
      find(path.substr(0, slash), path.substr(slash + 1)) != nullptr;
  }



  const Allowed &
  SceneSchema::allowed(const std::string &path) const
  {
    return at(path).allowed;
  }



  const std::string &
  SceneSchema::default_value(const std::string &path) const
  {
    return at(path).default_value;
  }



  std::string
  SceneSchema::unit_of(const std::string &documentation)
  {
    const std::size_t begin = documentation.rfind('[');
    return !documentation.empty() && documentation.back() == ']' ?
      documentation.substr(begin + 1, documentation.size() - begin - 2) :
      "";
  }



  const std::string &
  SceneSchema::unit(const std::string &path) const
  {
    return at(path).unit;
  }



  bool
  SceneSchema::is_changed(const std::string &path) const
  {
    return value(path) != at(path).default_value;
  }



  std::vector<std::string>
  SceneSchema::entries_of(const std::string &section) const
  {
    std::vector<std::string> paths;
    for (const auto &[name, entries] : sections)
      if (name == section)
        for (const Entry &entry : entries)
          paths.push_back(section + "/" + entry.name);
    return paths;
  }



  void
  SceneSchema::print(std::ostream &out, const bool with_documentation) const
  {
    std::ostringstream text;
    prm.print_parameters(text,
                         with_documentation ? ParameterHandler::PRM |
                             ParameterHandler::KeepDeclarationOrder :
                                              ParameterHandler::ShortPRM |
                             ParameterHandler::KeepDeclarationOrder);
    out << text.str();
  }



  const SceneSchema::Entry *
  SceneSchema::find(const std::string &section, const std::string &name) const
  {
    for (const auto &[section_name, entries] : sections)
      if (section_name == section)
        for (const Entry &entry : entries)
          if (entry.name == name)
            return &entry;
    return nullptr;
  }



  const SceneSchema::Entry &
  SceneSchema::at(const std::string &path) const
  {
    const std::size_t slash = path.find('/');
    const Entry *entry = find(path.substr(0, slash), path.substr(slash + 1));
    Assert(entry != nullptr, ExcInternalError());
    return *entry;
  }
} // namespace PlateImpact
