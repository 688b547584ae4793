#ifndef plate_impact_output_verdict_h
#define plate_impact_output_verdict_h

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/analysis/outcome.h"
#include "plate_impact/base/parameters.h"

#include <string>
#include <vector>

namespace PlateImpact
{
  /// How far the peak force of a run may be taken at its word.
  enum class Trust
  {
    good,     ///< the target is met, nothing to warn of
    doubtful, ///< a number with a reservation
    none      ///< the number says nothing
  };

  template <>
  const std::vector<std::pair<Trust, std::string>> &
  choices();


  /// What a reader must know before any other number.
  struct Verdict
  {
    Trust                    trust = Trust::good;
    std::string              text;    ///< force, error, and whether it is met
    std::vector<std::string> reasons; ///< why not better, sentences
  };

  /// The error is the numerical one; the model is another matter.
  /// @param warnings  that the run gives; any leaves a doubt
  Verdict
  verdict_of(const Parameters               &parameters,
             Outcome                         outcome,
             const CycleResult              &last,
             const std::vector<std::string> &warnings);
} // namespace PlateImpact

#endif
