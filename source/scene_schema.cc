#include "plate_impact/scene_schema.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// The whole text as a finite number; no other word than a number matches.
    template <typename T>
    bool
    to_number(const std::string &text, T &value)
    {
      const char *begin = text.data(), *end = begin + text.size();
      if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        ++begin;
      const auto [last, error] = std::from_chars(begin, end, value);
      return error == std::errc() && last == end &&
        std::isfinite(static_cast<double>(value));
    }



    std::string
    shortest(const double value)
    {
      char       text[32];
      const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
      return {text, end};
    }



    Allowed
    number(const std::string                 &words,
           const std::function<bool(double)> &in_range)
    {
      return {words, [in_range](const std::string &text) {
                double value;
                return to_number(text, value) && in_range(value);
              }};
    }



    /// "; did you mean ...?", empty when nothing is close.
    std::string
    suggestion(const std::string              &name,
               const std::vector<std::string> &candidates)
    {
      const std::string closest = closest_name(name, candidates);
      return closest.empty() ? "" : "; did you mean '" + closest + "'?";
    }



    template <typename T>
    void
    convert_pair(const std::string &text, std::array<T, 2> &value)
    {
      const std::vector<std::string> items =
        Utilities::split_string_list(text, ',');
      convert(items.at(0), value[0]);
      convert(items.at(1), value[1]);
    }
  } // namespace



  Allowed::Allowed(const std::string                              &words,
                   const std::function<bool(const std::string &)> &test)
    : words(words)
    , test(test)
  {}



  bool
  Allowed::match(const std::string &value) const
  {
    return test(value);
  }



  std::string
  Allowed::description(const OutputStyle) const
  {
    return words;
  }



  std::unique_ptr<Patterns::PatternBase>
  Allowed::clone() const
  {
    return std::make_unique<Allowed>(*this);
  }



  Allowed
  Allowed::number_above(const double bound)
  {
    return number("a number above " + shortest(bound),
                  [bound](const double x) { return x > bound; });
  }



  Allowed
  Allowed::number_from(const double first)
  {
    return number("a number not below " + shortest(first),
                  [first](const double x) { return x >= first; });
  }



  Allowed
  Allowed::number_between(const double lower, const double upper)
  {
    return number("a number above " + shortest(lower) + " and below " +
                    shortest(upper),
                  [lower, upper](const double x) {
                    return x > lower && x < upper;
                  });
  }



  Allowed
  Allowed::whole_number(const unsigned int first, const unsigned int last)
  {
    return {"a whole number from " + std::to_string(first) + " to " +
              std::to_string(last),
            [first, last](const std::string &text) {
              unsigned int value;
              return to_number(text, value) && value >= first && value <= last;
            }};
  }



  Allowed
  Allowed::one_of(const std::vector<std::string> &words)
  {
    std::string list;
    for (const std::string &word : words)
      list += (list.empty() ? "" : " | ") + word;
    return {list, [words](const std::string &text) {
              return std::find(words.begin(), words.end(), text) != words.end();
            }};
  }



  Allowed
  Allowed::truth()
  {
    return one_of({"true", "false"});
  }



  Allowed
  Allowed::anything(const std::string &words)
  {
    return {words, [](const std::string &) { return true; }};
  }



  Allowed
  Allowed::list(const Allowed     &item,
                const unsigned int first,
                const unsigned int last)
  {
    const std::string number = first == last
      ? std::to_string(first)
      : std::to_string(first) + " to " + std::to_string(last);
    return {number + " values separated by commas, each: " + item.words,
            [item, first, last](const std::string &text) {
              const std::vector<std::string> items =
                Utilities::split_string_list(text, ',');
              const bool ends_open = !text.empty() && text.back() == ',';
              return !ends_open && items.size() >= first &&
                items.size() <= last &&
                std::all_of(items.begin(), items.end(), item.test);
            }};
  }



  void
  SceneSchema::begin_section(const std::string &name)
  {
    sections.push_back({name, {}});
  }



  void
  SceneSchema::set(const std::string &section,
                   const std::string &entry,
                   const double       value)
  {
    prm.enter_subsection(section);
    prm.set(entry, shortest(value));
    prm.leave_subsection();
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
    std::vector<std::string> names, mistakes;
    for (const auto &section : sections)
      names.push_back(section.first);
    for (const Assignment &opening : openings)
      if (!has_section(opening.section))
        mistakes.push_back(opening.origin + ": there is no section '" +
                           opening.section + "'" +
                           suggestion(opening.section, names));
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

    prm.enter_subsection(assignment.section);
    std::string mistake;
    try
      {
        prm.set(assignment.entry, assignment.value);
        origins[assignment.path()] = assignment.origin;
      }
    catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
      {
        mistake = assignment.path() + " = " +
          (assignment.value.empty() ? "(nothing)" : assignment.value) +
          " is not allowed; expected " + entry->allowed;
      }
    prm.leave_subsection();
    return mistake;
  }



  std::string
  SceneSchema::unknown(const Assignment &assignment) const
  {
    std::vector<std::string> names;
    std::string              elsewhere;
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
      (hint.empty() && !elsewhere.empty()
         ? "; it belongs to section " + elsewhere
         : hint);
  }



  std::string
  SceneSchema::origin(const std::string &path) const
  {
    const auto set_at = origins.find(path);
    return set_at == origins.end() ? "default" : set_at->second;
  }



  std::string
  SceneSchema::value(const std::string &path) const
  {
    const std::size_t slash = path.find('/');
    return prm.get({path.substr(0, slash)}, path.substr(slash + 1));
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
                             ParameterHandler::KeepDeclarationOrder
                                            : ParameterHandler::ShortPRM |
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



  void
  convert(const std::string &text, double &value)
  {
    to_number(text, value);
  }



  void
  convert(const std::string &text, unsigned int &value)
  {
    to_number(text, value);
  }



  void
  convert(const std::string &text, bool &value)
  {
    value = text == "true";
  }



  void
  convert(const std::string &text, std::string &value)
  {
    value = text;
  }



  void
  convert(const std::string &text, std::vector<std::string> &value)
  {
    value = Utilities::split_string_list(text, ',');
  }



  void
  convert(const std::string &text, std::array<double, 2> &value)
  {
    convert_pair(text, value);
  }



  void
  convert(const std::string &text, std::array<unsigned int, 2> &value)
  {
    convert_pair(text, value);
  }
} // namespace PlateImpact
