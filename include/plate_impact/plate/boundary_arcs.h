#ifndef plate_impact_plate_boundary_arcs_h
#define plate_impact_plate_boundary_arcs_h

#include "plate_impact/base/plate_file.h"

namespace PlateImpact
{
  /// Finds sides of one edge that are chords of a circle, nine or more to a
  /// full turn, and makes them parts of arcs.
  void
  find_arcs(PlateFile &plate);
} // namespace PlateImpact

#endif
