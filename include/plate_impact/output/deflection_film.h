#ifndef plate_impact_output_deflection_film_h
#define plate_impact_output_deflection_film_h

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/plate/plate_discretization.h"

#include <nlohmann/json.hpp>

namespace PlateImpact
{
  /// Deflection and local error ratios over the frames of a result, the plate
  /// at rest before them and that of the largest force among them, for the
  /// player of a page (Page::film()):
  ///
  ///  - `times` [s], `forces` [N] of the nearest steps, `errors` ||e||/||u*||;
  ///  - `corners`: x and y of the four corners of every cell [m], float32;
  ///  - `deflections`: at `nodesPerCell` nodes of every cell, 9 or, on meshes
  ///    of many cells, the 4 corners, row by row; int16 in units of
  ///    `deflectionUnit` [m], frame after frame;
  ///  - `cellErrors`: log10 of xi_i(t), int16 in units of 1e-4; -32768 where it
  ///    is 0;
  ///  - `patch`: the radius of the load around the origin [m], 0 without one;
  ///    `symmetric`: whether the plate mirrors in x = 0, y = 0.
  ///
  /// Corners, deflections and errors are base64 of little-endian numbers: a
  /// page should stay small. On large meshes frames are left out, on very large
  /// ones all: the result is then null.
  nlohmann::ordered_json
  deflection_film(const Parameters          &parameters,
                  const CycleResult         &result,
                  const PlateDiscretization &discretization);
} // namespace PlateImpact

#endif
