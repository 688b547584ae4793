#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/analysis/goal.h"
#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/parameters.h"

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
} // namespace PlateImpact
