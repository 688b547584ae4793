#pragma once

#include "plate_impact/analysis/goal.h"

#include <memory>
#include <optional>

namespace PlateImpact
{
  /// When an analysis ends and what its next mesh is made for: by default, as
  /// Table 1 of the paper, when the goal of the scene is met.
  class AdaptationControl
  {
  public:
    explicit AdaptationControl(const AdaptivityParameters &adaptivity)
      : adaptivity(adaptivity)
      , goal(make_goal(adaptivity))
      , target(adaptivity.target())
    {}

    virtual ~AdaptationControl() = default;

    /// Why the analysis ends with this cycle; empty when it goes on.
    virtual std::optional<Outcome>
    check(const CycleResult &result)
    {
      if (!adaptivity.is_adaptive() || !result.error_ratios)
        return Outcome::single_mesh;
      if (const auto outcome = goal->outcome(result))
        return outcome;
      if (result.cycle == adaptivity.maximum_cycles)
        return Outcome::maximum_cycles;
      return {};
    }

    /// Where the target gives no other mesh: whether there is a smaller one to
    /// try.
    virtual bool
    tighten()
    {
      return false;
    }

    /// Errors of the cells, by what the next mesh is made for.
    virtual ErrorRatios
    error_ratios(const Cycle &cycle) const
    {
      return goal->error_ratios(cycle, target);
    }

  protected:
    const AdaptivityParameters        adaptivity;
    const std::unique_ptr<const Goal> goal;
    double                            target;
  };
} // namespace PlateImpact
