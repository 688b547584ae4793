#ifndef plate_impact_scene_sweep_scene_h
#define plate_impact_scene_sweep_scene_h

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

    /// Whether points of it may adapt their mesh.
    bool
    may_adapt() const
    {
      return base.adaptivity.is_adaptive() ||
        plan.sweeps("Adaptivity/Strategy");
    }

    /// Whether its plate is a laminate where no lay-up is swept.
    bool
    is_laminate() const
    {
      return base.plate.is_laminate();
    }

    /// The scene with the points' values left out.
    const Parameters &
    parameters() const
    {
      return base;
    }

    /// Every value, as a scene that repeats the sweep.
    const std::string &
    text() const
    {
      return base_text;
    }

    /// @throws InputError when its values are not valid together, or without an
    ///         impactor
    SweepPoint
    point(std::size_t index);

    const std::string name; ///< of the file, printable
    const SweepPlan   plan;

  private:
    std::string base_text;
    Parameters  base;
  };
} // namespace PlateImpact

#endif
