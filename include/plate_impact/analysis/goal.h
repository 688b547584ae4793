#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/base/choices.h"
#include "plate_impact/base/parameters.h"

#include <memory>
#include <optional>
#include <string>

namespace PlateImpact
{
  /// Why an analysis ends; word_for() it in what a user reads.
  enum class Outcome
  {
    single_mesh,
    target_reached,
    maximum_cycles,
    maximum_cells,
    mesh_unchanged,
    time_step_too_coarse,
    time_budget,
    minimum_cell_size,
    nearly_as_fine_as_the_reference
  };

  template <>
  const std::vector<Word<Outcome>> Choices<Outcome>::words;


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
