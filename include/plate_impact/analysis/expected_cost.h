#pragma once

#include "plate_impact/base/parameters.h"

namespace PlateImpact
{
  /// What an adaptive run costs that reaches its target.
  struct ExpectedCost
  {
    double cells; ///< of the last mesh
    double steps; ///< on it
  };

  /// Foretold by the first two meshes of the run, which are computed; mostly
  /// right to a factor of two. Seconds cannot be said as well: per unknown and
  /// cycle they differ by a hundred between scenes.
  /// @param scene  complete; with an impactor and a mesh that adapts itself
  /// @throws ComputationError as ImpactAnalysis::run()
  ExpectedCost
  expected_cost(const Parameters &scene);
} // namespace PlateImpact
