#ifndef plate_impact_plate_plate_file_boundary_h
#define plate_impact_plate_plate_file_boundary_h

#include "plate_impact/base/plate_file.h"

#include <map>

namespace PlateImpact
{
  /// Finds the sides of one cell alone, with the arcs that they are parts of,
  /// and what follows: outline, extent, area, with the origin in the middle of
  /// the rectangle around the plate.
  /// @param plate          with vertices, cells and the edges' names
  /// @param group_of_side  the edges of sides that have one, by sorted vertices
  /// @throws InputError    a sentence that goes on from the name of the file
  void
  find_boundary(PlateFile                                &plate,
                const std::map<VertexPair, unsigned int> &group_of_side);
} // namespace PlateImpact

#endif
