#pragma once

#include "plate_impact/base/text.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/scene/scene_reader.h"
#include "plate_impact/scene/sweep_plan.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// A point of a sweep that has passed every check.
  struct SweepPoint
  {
    Parameters  parameters;
    ZenerImpact expected;
  };


  /// A scene whose entries are swept. The file is read once; a point is the
  /// scene with its values in place, checked and completed as by read_scene().
  class SweepScene
  {
    SceneReader reader; // before what is read by it

  public:
    /// @throws InputError with every mistake that is not one of single points
    SweepScene(const std::string                &path,
               const std::vector<std::string>   &overrides,
               const std::optional<std::string> &output);

    /// @throws InputError when its values are not valid together, or without an
    ///         impactor
    SweepPoint
    point(std::size_t index);

    const std::string name; ///< of the file, printable
    const SweepPlan   plan;
    Parameters        parameters; ///< the points' values left out
    std::string       text; ///< every value, as a scene that repeats the sweep
  };
} // namespace PlateImpact
