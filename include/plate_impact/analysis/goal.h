#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/analysis/outcome.h"
#include "plate_impact/base/parameters.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What the meshes of an analysis are made for.
  class Goal
  {
  public:
    explicit Goal(const AdaptivityParameters &adaptivity)
      : adaptivity(adaptivity)
    {}

    virtual ~Goal() = default;

    /// What better meshes make smaller: eta, or the mesh's part of the error of
    /// the peak force, infinite where it cannot be estimated.
    virtual double
    error(const CycleResult &result) const = 0;

    /// Whether the error of the whole meets the target of the scene.
    virtual bool
    is_met(const CycleResult &result) const = 0;

    /// Whether there is what the scene asks for, or no mesh can have it; empty
    /// where a better mesh is to come.
    virtual std::optional<Outcome>
    outcome(const CycleResult &result) const = 0;

    /// Errors of the cells by what a target allows of them.
    virtual ErrorRatios
    error_ratios(const Cycle &cycle, double target) const = 0;

    /// Why the target is not met, and what helps; empty where it is.
    virtual std::string
    warning(const CycleResult &result) const = 0;

  protected:
    const AdaptivityParameters adaptivity;
  };

  /// The goal that the scene names.
  std::unique_ptr<const Goal>
  make_goal(const AdaptivityParameters &adaptivity);
} // namespace PlateImpact
