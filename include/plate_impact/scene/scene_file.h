#pragma once

#include <istream>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// One `set Entry = value` of a scene, with the place it comes from.
  struct Assignment
  {
    std::string section;
    std::string entry;
    std::string value;
    std::string origin; ///< "scene.prm:12" or "--set"

    std::string
    path() const
    {
      return section + "/" + entry;
    }
  };

  /// The text of a scene file taken apart, before anything is known about what
  /// its entries mean.
  struct SceneFile
  {
    std::vector<Assignment> assignments;
    std::vector<Assignment> sections; ///< where they begin, without an entry
    std::vector<std::string>
      mistakes; ///< one sentence each, with file and line
  };

  /// Reads the grammar of deal.II's ParameterHandler (`subsection`, `set`,
  /// `end`, comments from `#` to the end of the line), but goes on after a
  /// mistake, so that a user sees all of them at once. Byte order marks and
  /// Windows line ends are accepted; sections within sections, entries set
  /// twice and anything else are mistakes.
  /// @param name  of the file, for the mistakes
  SceneFile
  scan_scene(std::istream &in, const std::string &name);

  /// Whether a text can stand in a line of a scene: without '#' and control
  /// characters.
  bool
  can_be_set(const std::string &text);

  /// Takes "Section/Entry=value" of the command line apart.
  /// @throws InputError when there is no section, entry or `=`
  Assignment
  parse_override(const std::string &text);

  /// The candidate closest to a misspelled name, or an empty string when none
  /// is close enough to be meant (edit distance beyond a third of its length).
  std::string
  closest_name(const std::string              &name,
               const std::vector<std::string> &candidates);
} // namespace PlateImpact
