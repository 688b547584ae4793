#include "plate_impact/analysis/adaptation_control.h"

namespace PlateImpact
{
  AdaptationControl::AdaptationControl(const AdaptivityParameters &adaptivity)
    : adaptivity(adaptivity)
    , target(adaptivity.target())
  {}



  std::optional<Outcome>
  AdaptationControl::check(const CycleResult &result)
  {
    if (!adaptivity.is_adaptive() || !result.over_limit)
      return Outcome::single_mesh;
    if (is_met(result))
      return Outcome::target_reached;
    if (result.cycle == adaptivity.maximum_cycles)
      return Outcome::maximum_cycles;
    return {};
  }



  bool
  AdaptationControl::is_met(const CycleResult &result) const
  {
    if (adaptivity.goal == AdaptationGoal::peak_force)
      return result.peak_force_bar &&
        result.peak_force_bar->total() <= adaptivity.target_peak_force_error;
    return result.over_limit->overall <= 1. &&
      result.cells_above_limit == result.cells_at_minimum_size;
  }



  bool
  AdaptationControl::tighten()
  {
    return false;
  }



  double
  AdaptationControl::target_error() const
  {
    return target;
  }
} // namespace PlateImpact
