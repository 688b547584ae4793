#ifndef plate_impact_plate_plate_file_overlaps_h
#define plate_impact_plate_plate_file_overlaps_h

#include "plate_impact/base/plate_file.h"

namespace PlateImpact
{
  /// Convex cells, counterclockwise, lie on each other nowhere when their
  /// corners do not overlap at any vertex and no side of the boundary crosses
  /// another.
  ///
  /// @throws InputError  a sentence that goes on from the name of the file
  void
  refuse_overlaps(const PlateFile &plate);
} // namespace PlateImpact

#endif
