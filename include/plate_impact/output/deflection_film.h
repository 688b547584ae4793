#ifndef plate_impact_output_deflection_film_h
#define plate_impact_output_deflection_film_h

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/page/page.h"
#include "plate_impact/plate/plate_discretization.h"

namespace PlateImpact
{
  /// Deflection and local error ratios over the frames of a result, the plate
  /// at rest before them and that of the largest force among them, for the
  /// player of a page:
  ///
  ///  - `times` [s], `forces` [N] of the nearest steps, `errors` ||e||/||u*||;
  ///  - `deflections`: at `nodesPerCell` nodes of every cell, 9 or, on meshes
  ///    of many cells, the 4 corners, row by row; int16 in units of
  ///    `deflectionUnit` [m], frame after frame;
  ///  - `cellErrors`: log10 of xi_i(t), int16 in units of 1e-4; -32768 where it
  ///    is 0.
  ///
  /// Deflections and errors are base64 of little-endian numbers: a page should
  /// stay small. On large meshes frames are left out, on very large ones all:
  /// the result is then null.
  Json
  deflection_film(const CycleResult         &result,
                  const PlateDiscretization &discretization);
} // namespace PlateImpact

#endif
