#pragma once

#include "plate_impact/base/choices.h"

namespace PlateImpact
{
  /// Why an analysis ends; word_for() it in what a user reads.
  enum class Outcome
  {
    single_mesh,
    target_reached,
    maximum_cycles,
    maximum_cells,
    mesh_unchanged,
    time_step_too_coarse,
    time_budget,
    minimum_cell_size,
    nearly_as_fine_as_the_reference
  };

  template <>
  const std::vector<Word<Outcome>> Choices<Outcome>::words;
} // namespace PlateImpact
