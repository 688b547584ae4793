#ifndef plate_impact_command_compare_h
#define plate_impact_command_compare_h

#include "plate_impact/scene/scene.h"

namespace PlateImpact
{
  /// Computes the comparison of a scene, and writes and prints what is found:
  /// comparison.csv, a row per mesh as soon as it is known; comparison.json
  /// with the reference and who reaches which error first, and comparison.html,
  /// after every curve.
  /// @param quiet  only warnings and errors are printed
  /// @throws InputError for a scene without an impactor
  /// @throws ComputationError; files written so far are then valid
  void
  compare_scene(const Scene &scene, bool quiet);
} // namespace PlateImpact

#endif
