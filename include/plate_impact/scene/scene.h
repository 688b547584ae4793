#pragma once

#include "plate_impact/scene/sweep_scene.h"

#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace PlateImpact
{
  /// A scene that has passed every check.
  struct Scene
  {
    std::string name; ///< of the file, printable
    Parameters  parameters;
    std::string text;  ///< every value used, as a scene that repeats the run
    Parameters  given; ///< with the zeros that let the program choose
    std::optional<ZenerImpact> expected; ///< of an impactor
    SweepPlan                  sweep;
    std::vector<std::pair<std::string, std::string>>
      inputs; ///< entries by their paths, with the values used
  };

  /// Reads a scene file, the overrides "Section/Entry=value" and the output
  /// directory of the command line on top of it,
  /// checks every entry and the entries against each other, and replaces zeros
  /// that mean "chosen by the program" by what is chosen: the impactor's mass,
  /// the patch radius, the minimum cell size.
  /// @throws InputError with every mistake found: file, line, entry, value and
  ///         what is allowed
  Scene
  read_scene(const std::string                &path,
             const std::vector<std::string>   &overrides,
             const std::optional<std::string> &output = {});

  /// Prints every entry with its meaning, unit and default, as a valid scene.
  void
  print_defaults(std::ostream &out);
} // namespace PlateImpact
