#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/output/result_directory.h"
#include "plate_impact/output/run_in_words.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <string>

namespace PlateImpact
{
  /// fields.pvd and a VTU file for every snapshot of the whole plate:
  /// deflection, rotations, recovered resultants, stresses at the faces, xi'.
  /// @throws ComputationError when a field holds more than a file takes
  void
  write_fields(const ResultDirectory &directory, const Cycle &cycle);

  /// The plate over the frames of a result, the plate at rest before them and
  /// that of the largest force among them, for the player of a page:
  ///
  ///  - `times` [s], `forces` [N] of the nearest steps, `errors` ||e||/||u*||;
  ///  - `nodesPerSide`: values of a cell stand at so many points along its
  ///    sides and between them, row by row: 2 on meshes of many cells, or more;
  ///  - `deflections`: int16 in units of `deflectionUnit` [m], frame after
  ///    frame;
  ///  - `fields`: resultants and stresses, recovered, each with `name`, `unit`,
  ///    `isOdd` across x = 0 and y = 0, `largest`, and `values`, int8: the
  ///    signed root of the value over the largest, in units of 1/127. None
  ///    where they would leave too few frames;
  ///  - `cellErrors`: log10 of xi_i(t), int16 in units of 1e-4; -32768 where it
  ///    is 0.
  ///
  /// Those arrays are base64 of little-endian numbers. On large meshes frames
  /// are left out, on very large ones all: the result is then null.
  Json
  deflection_film(const Cycle &cycle);

  /// A history for a page: every so many of its states, with the last and that
  /// of the largest force.
  /// @param has_all  displacements and energies besides `time` and `force`
  Json
  history_on_page(const ContactHistory &history, bool has_all = false);

  /// Adds what report.html shows of a cycle, since the meshes do not stay, to
  /// its lists: `histories`, `errors`, `meshes`, `stresses`.
  void
  add_to_report(const Cycle &cycle, Json &study);

  /// report.html: a run on one page.
  /// @param last   for the film of the deflection
  /// @param study  with all cycles, the text of the scene and summary.json
  std::string
  report(const Scene   &scene,
         const Verdict &verdict,
         const Cycle   &last,
         Json           study);
} // namespace PlateImpact
