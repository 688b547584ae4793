#ifndef plate_impact_command_run_h
#define plate_impact_command_run_h

#include "plate_impact/scene/scene.h"

namespace PlateImpact
{
  /// Computes the impact of a scene cycle by cycle, and writes and prints what
  /// is found.
  /// @param quiet  only warnings and errors are printed
  /// @throws ComputationError; files written so far are then valid, and
  ///         summary.json tells of the failure
  void
  run_scene(const Scene &scene, bool quiet);
} // namespace PlateImpact

#endif
