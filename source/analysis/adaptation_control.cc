#include "plate_impact/analysis/adaptation_control.h"

#include <limits>

namespace PlateImpact
{
  bool
  meets_force_target(const CycleResult          &result,
                     const AdaptivityParameters &adaptivity)
  {
    return result.peak_force_bar &&
      result.peak_force_bar->total() <= adaptivity.target_peak_force_error;
  }



  double
  error_of_goal(const CycleResult          &result,
                const AdaptivityParameters &adaptivity)
  {
    if (adaptivity.goal == AdaptationGoal::energy_norm)
      return result.error->eta;
    return result.peak_force_error ? bar_of_mesh(*result.peak_force_error) :
                                     std::numeric_limits<double>::infinity();
  }



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
    if (step_is_too_coarse(result))
      return Outcome::time_step_too_coarse;
    if (result.cycle == adaptivity.maximum_cycles)
      return Outcome::maximum_cycles;
    return {};
  }



  bool
  AdaptationControl::is_met(const CycleResult &result) const
  {
    if (adaptivity.goal == AdaptationGoal::peak_force)
      return meets_force_target(result, adaptivity);
    return result.over_limit->overall <= 1. &&
      result.cells_above_limit == result.cells_at_minimum_size;
  }



  bool
  AdaptationControl::step_is_too_coarse(const CycleResult &result) const
  {
    if (adaptivity.goal != AdaptationGoal::peak_force || !result.peak_force_bar)
      return false;
    // the mesh may have half of the target in any case
    const PeakForceBar &bar    = *result.peak_force_bar;
    const double        target = adaptivity.target_peak_force_error;
    return bar.space <= 0.5 * target && bar.total() > target;
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
