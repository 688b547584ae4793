#include "plate_impact/transient/sensitivity.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  Sensitivity
  sensitivity_to_velocity(
    const ContactHistory                                  &history,
    const Impactor                                        &impactor,
    const std::function<ContactHistory(const Impactor &)> &strike)
  {
    const double change = 1e-6, unpredictable = 1e-3;
    Sensitivity  result;
    const double peak = history.peak().force;
    if (peak <= 0.)
      return result;
    Impactor faster = impactor;
    faster.velocity *= 1. + change;
    const ContactHistory other = strike(faster);
    for (std::size_t step = 0; step < history.states().size(); ++step)
      {
        const ContactState &state = history.states()[step];
        const double        changed =
          std::abs(other.states()[step].force - state.force) / peak;
        result.factor = std::max(result.factor, changed / change);
        if (changed > unpredictable && !result.unpredictable_from)
          result.unpredictable_from = state.time;
      }
    return result;
  }
} // namespace PlateImpact
