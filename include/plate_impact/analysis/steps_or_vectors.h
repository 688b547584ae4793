#ifndef plate_impact_analysis_steps_or_vectors_h
#define plate_impact_analysis_steps_or_vectors_h

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/transient/newmark_scheme.h"

#include <limits>

namespace PlateImpact
{
  /// Whether an impact is stepped on the mesh because Ritz vectors were more
  /// than steps, or nearly so, on a mesh before: a finer mesh needs more
  /// vectors, and one of about its size as many.
  class StepsOrVectors
  {
  public:
    bool
    vectors_are_too_many(const TimeParameters &time,
                         const unsigned int    n_unknowns) const
    {
      return n_unknowns >= unknowns && NewmarkScheme(time).n_steps <= steps;
    }

    void
    note(const CycleResult &seen)
    {
      const bool was_in_vain = seen.new_vectors > 0 &&
        seen.new_solves >= seen.new_vectors + 0.5 * seen.steps;
      if (!was_in_vain && seen.new_vectors <= 0.7 * seen.steps)
        return;
      unknowns = seen.degrees_of_freedom / 2;
      steps    = seen.steps;
    }

  private:
    unsigned int unknowns = std::numeric_limits<unsigned int>::max(), steps = 0;
  };
} // namespace PlateImpact

#endif
