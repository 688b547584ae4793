#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/analysis/goal.h"
#include "plate_impact/analysis/warnings.h"
#include "plate_impact/output/result_directory.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <algorithm>
#include <string>
#include <vector>

namespace PlateImpact
{
  std::string
  scene_in_words(const Parameters &parameters);

  /// The local response under the contact, and why where it is the only one
  /// that fits. For scenes with an impactor.
  std::string
  local_response_in_words(const Parameters &parameters);


  /// How far a part of a result may be taken at its word.
  enum class Trust
  {
    good,     ///< nothing to warn of
    doubtful, ///< with a reservation
    none      ///< the number says nothing
  };

  template <>
  inline const std::vector<Word<Trust>> Choices<Trust>::words = {
    {Trust::good, "good"},
    {Trust::doubtful, "doubtful"},
    {Trust::none, "none"}};


  /// What a reader must know before any other number, in two parts that have
  /// nothing to do with each other: a force may be converged and wrong.
  struct Verdict
  {
    struct Part
    {
      Trust                    trust = Trust::good;
      std::vector<std::string> reasons; ///< why not better, sentences
    };

    std::string text; ///< force, errors, and whether the target is met

    std::string force;    ///< with its errors
    Warnings    warnings; ///< that it rests on

    /// Whether mesh and time step leave the force as it is: the bar.
    Part convergence;

    /// Whether the impact stays inside of the model; none where it passes a
    /// limit more than three times over.
    Part model;

    /// The worse of both.
    Trust
    trust() const
    {
      return std::max(convergence.trust, model.trust);
    }
  };

  Verdict
  verdict_of(const Parameters  &parameters,
             Outcome            outcome,
             const CycleResult &last,
             const Warnings    &warnings);

  /// Where the impact is: "Outside the limits of the model".
  inline std::string
  model_in_words(const Verdict &verdict)
  {
    const std::string limits = " the limits of the model";
    if (!verdict.warnings.model.empty())
      return (verdict.model.trust == Trust::doubtful ? "Outside" :
                                                       "Far outside") +
        limits;
    return "Within" + limits +
      (verdict.warnings.assumes_elastic_contact ? ", elastic contact assumed" :
                                                  "");
  }


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
