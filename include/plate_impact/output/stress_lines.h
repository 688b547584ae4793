#ifndef plate_impact_output_stress_lines_h
#define plate_impact_output_stress_lines_h

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/page/page.h"

namespace PlateImpact
{
  /// What recovery makes of the stresses of the elements, along x, y and the
  /// diagonal, from the impact to the edge, for a page: `fields`, their names
  /// and units, and `lines`, each with a `title`, `distance` from the impact
  /// [m], and the values of the fields as the elements have them, `raw`, and
  /// `recovered`. Cells are set apart by a null, since raw values jump between
  /// them.
  Json
  stress_lines(const Cycle &cycle, const Snapshot &state);
} // namespace PlateImpact

#endif
