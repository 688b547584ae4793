#include "plate_impact/analysis/outcome.h"

namespace PlateImpact
{
  template <>
  const std::vector<Word<Outcome>> Choices<Outcome>::words = {
    {Outcome::single_mesh, "single mesh"},
    {Outcome::target_reached, "target reached"},
    {Outcome::maximum_cycles, "maximum cycles"},
    {Outcome::maximum_cells, "maximum cells"},
    {Outcome::mesh_unchanged, "mesh unchanged"},
    {Outcome::time_step_too_coarse, "time step too coarse"},
    {Outcome::time_budget, "time budget"},
    {Outcome::minimum_cell_size, "minimum cell size"},
    {Outcome::nearly_as_fine_as_the_reference,
     "nearly as fine as the reference"}};
} // namespace PlateImpact
