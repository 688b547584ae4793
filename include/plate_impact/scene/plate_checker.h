#ifndef plate_impact_scene_plate_checker_h
#define plate_impact_scene_plate_checker_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/scene/scene_mistakes.h"
#include "plate_impact/scene/scene_schema.h"

namespace PlateImpact
{
  /// Checks the entries of the plate against each other and against its file.
  class PlateChecker
  {
  public:
    /// @param scene  what the file and the lay-up tell is filled in
    PlateChecker(const SceneSchema &schema,
                 Parameters        &scene,
                 SceneMistakes     &mistakes);

    /// Reads the plate from its file, unless it is there already.
    void
    read();

    /// Lay-up or isotropic material.
    void
    check_section();

    /// Outline, supports and what must lie within; needs the load's shape.
    void
    check_shape();

  private:
    void
    check_edges();
    void
    check_extent();

    const SceneSchema &schema;
    Parameters        &scene;
    SceneMistakes     &mistakes;
    bool               is_unknown = false; ///< its file cannot be read
  };
} // namespace PlateImpact

#endif
