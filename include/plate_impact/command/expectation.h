#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/transient/plate_model.h"

#include <array>

/// What a scene is expected to give and to cost, before it is computed.
namespace PlateImpact
{
  /// On a uniform mesh of the best element.
  PlateModel
  coarse_plate(const Parameters                  &parameters,
               const std::array<unsigned int, 2> &n_cells);

  /// The impact on a coarse mesh, in steps of 1/64 of the contact, up to its
  /// end: where the contact outlasts what Zener's equation expects, end and
  /// step are extended together.
  CycleResult
  coarse_impact(const Parameters &scene, const ZenerImpact &expected);


  /// What a run is to cost that reaches its target.
  struct Cost
  {
    double cells; ///< of the last mesh
    double steps; ///< on a mesh
  };

  /// About: of an adaptive run from its first two meshes, which it computes:
  /// eta falls about as the number of cells grows, and the bar of the force
  /// as if every cell were halved, which only late peaks need. On the scenes
  /// of prm/ mostly right to a factor of two. Small targets are said to cost
  /// too much, one of 0.5 % seventeen times as many cells as it did. Seconds
  /// cannot be said as well: per unknown and cycle they differ by a hundred
  /// between scenes.
  Cost
  cost_by_two_meshes(Parameters parameters);
} // namespace PlateImpact
