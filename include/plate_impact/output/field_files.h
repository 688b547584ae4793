#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/output/result_directory.h"

namespace PlateImpact
{
  /// fields.pvd and a VTU file for every snapshot of the whole plate:
  /// deflection, rotations, recovered resultants, stresses at the faces, xi'.
  /// @throws ComputationError when a field holds more than a file takes
  void
  write_fields(const ResultDirectory &directory, const Cycle &cycle);
} // namespace PlateImpact
