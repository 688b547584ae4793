#include "plate_impact/scene/scene_file.h"

#include "plate_impact/base/exceptions.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/trim_all.hpp>

#include <algorithm>
#include <map>
#include <numeric>

namespace PlateImpact
{
  namespace
  {
    /// Without white space at both ends and with single spaces within.
    std::string
    simplified(const std::string &text)
    {
      return boost::algorithm::trim_fill_copy(text, " ");
    }



    bool
    is_text(const std::string &line)
    {
      return std::none_of(line.begin(), line.end(), [](const unsigned char c) {
        return (c < 0x20 && c != '\t') || c == 0x7f;
      });
    }



    /// Takes lines one after another.
    struct Scanner
    {
      void
      read(const std::string &line)
      {
        const std::string command = line.substr(0, line.find(' '));
        const std::string rest    = simplified(line.substr(command.size()));
        if (command == "subsection")
          open(rest);
        else if (command == "end" && rest.empty() && open_sections.empty())
          mistake("'end' without a 'subsection' before it");
        else if (command == "end" && rest.empty())
          open_sections.pop_back();
        else if (command == "set")
          set(rest);
        else if (!line.empty())
          mistake("'" + line +
                  "' is not understood; a line is 'subsection NAME', 'set "
                  "ENTRY = VALUE', 'end' or a comment after '#'");
      }

      void
      mistake(const std::string &text)
      {
        scene.mistakes.push_back(origin + ": " + text);
      }

      void
      open(const std::string &name_of_section)
      {
        if (name_of_section.empty())
          mistake("'subsection' needs a name");
        else if (!open_sections.empty())
          mistake("subsection " + name_of_section +
                  " begins within subsection " + open_sections.back() +
                  "; an 'end' is missing before it");
        if (!name_of_section.empty())
          scene.sections.push_back({name_of_section, "", "", origin});
        open_sections.push_back(name_of_section);
      }

      void
      set(const std::string &text)
      {
        const std::size_t equals = text.find('=');
        const std::string entry  = simplified(text.substr(0, equals));
        if (equals == std::string::npos || entry.empty())
          return mistake("'set " + text +
                         "' is not of the form 'set ENTRY = VALUE'");
        if (open_sections.empty())
          return mistake("'" + entry + "' is set outside of any subsection");
        const std::string &section = open_sections.back();
        if (section.empty())
          return; // its missing name is the mistake

        const std::string path     = section + "/" + entry;
        const auto [first, is_new] = first_set.insert({path, line_number});
        if (!is_new)
          return mistake(path + " is set twice, first in line " +
                         std::to_string(first->second));
        scene.assignments.push_back(
          {section, entry, simplified(text.substr(equals + 1)), origin});
      }

      SceneFile                           scene;
      std::string                         origin;
      std::vector<std::string>            open_sections;
      unsigned int                        line_number = 0;
      std::map<std::string, unsigned int> first_set;
    };
  } // namespace



  SceneFile
  scan_scene(std::istream &in, const std::string &name)
  {
    Scanner scanner;
    for (std::string line; std::getline(in, line);)
      {
        if (++scanner.line_number == 1 &&
            line.compare(0, 3, "\xEF\xBB\xBF") == 0)
          line.erase(0, 3);
        scanner.origin = name + ":" + std::to_string(scanner.line_number);
        if (!is_text(line.substr(0, line.find_last_not_of('\r') + 1)))
          {
            scanner.mistake(
              "this line holds control characters; a scene is a text file");
            return scanner.scene;
          }
        scanner.read(simplified(line.substr(0, line.find('#'))));
      }
    if (!scanner.open_sections.empty())
      scanner.mistake("the file ends within subsection " +
                      scanner.open_sections.back() + "; an 'end' is missing");
    return scanner.scene;
  }



  bool
  can_be_set(const std::string &text)
  {
    return text.find('#') == std::string::npos && is_text(text);
  }



  Assignment
  parse_override(const std::string &text)
  {
    const std::size_t equals = text.find('=');
    const std::size_t slash  = text.substr(0, equals).find('/');
    Assignment        assignment;
    if (equals != std::string::npos && slash != std::string::npos)
      assignment = {simplified(text.substr(0, slash)),
                    simplified(text.substr(slash + 1, equals - slash - 1)),
                    simplified(text.substr(equals + 1)),
                    "--set"};
    if (assignment.section.empty() || assignment.entry.empty())
      throw InputError(
        {"--set '" + text + "' is not of the form 'Section/Entry=value'"});
    if (!can_be_set(text))
      throw InputError({"--set '" + text +
                        "' contains a character that is not allowed in a "
                        "scene: '#' or a control character"});
    return assignment;
  }



  std::string
  closest_name(const std::string              &name,
               const std::vector<std::string> &candidates)
  {
    // Levenshtein distance, row by row
    const auto distance = [](const std::string &a, const std::string &b) {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i + 1;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
              diagonal                      = row[j + 1];
              row[j + 1] = std::min({substituted, diagonal + 1, row[j] + 1});
            }
        }
      return row.back();
    };

    using boost::algorithm::to_lower_copy;
    std::string closest;
    std::size_t best = std::string::npos;
    for (const std::string &candidate : candidates)
      if (const std::size_t d =
            distance(to_lower_copy(name), to_lower_copy(candidate));
          d < best && d <= 1 + candidate.size() / 3)
        {
          best    = d;
          closest = candidate;
        }
    return closest;
  }
} // namespace PlateImpact
