#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/base/choices.h"
#include "plate_impact/base/parameters.h"

#include <limits>
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


  /// What the meshes of an analysis are made for: the error of the stresses in
  /// the energy norm and xi' of every cell that may still be refined (Table 1
  /// of the paper), or the error bar of the peak force.
  class Goal
  {
  public:
    explicit Goal(const AdaptivityParameters &adaptivity)
      : adaptivity(adaptivity)
      , is_for_peak(adaptivity.goal == AdaptationGoal::peak_force)
    {}

    /// What better meshes make smaller: eta, or the mesh's part of the error of
    /// the peak force, infinite where it cannot be estimated.
    double
    error(const CycleResult &result) const
    {
      if (!is_for_peak)
        return result.error->eta;
      return result.peak_force_error ? result.peak_force_error->bar() :
                                       std::numeric_limits<double>::infinity();
    }

    /// Whether the error of the whole meets the target of the scene.
    bool
    is_met(const CycleResult &result) const
    {
      return is_for_peak ?
        result.peak_force_bar &&
          result.peak_force_bar->total() <= adaptivity.target() :
        result.error && result.error->eta <= adaptivity.target();
    }

    /// Whether there is what the scene asks for, or no mesh can have it; empty
    /// where a better mesh is to come.
    std::optional<Outcome>
    outcome(const CycleResult &result) const
    {
      const unsigned int n_exempt =
        adaptivity.singular_cells_count ? 0 : result.cells_at_minimum_size;
      if (is_met(result) &&
          (is_for_peak || result.cells_above_limit == n_exempt))
        return Outcome::target_reached;
      // the mesh may have half of the target in any case
      if (is_for_peak && result.peak_force_bar &&
          result.peak_force_bar->space <= 0.5 * adaptivity.target())
        return Outcome::time_step_too_coarse;
      return {};
    }

    /// Errors of the cells by what a target allows of them.
    ErrorRatios
    error_ratios(const Cycle &cycle, double target) const;

    /// Why the target is not met, and what helps; empty where it is.
    std::string
    warning(const CycleResult &result) const;

    const AdaptivityParameters adaptivity;

  private:
    const bool is_for_peak;
  };


  /// When an analysis ends and what its next mesh is made for: by default, as
  /// Table 1 of the paper, when the goal of the scene is met.
  class AdaptationControl
  {
  public:
    explicit AdaptationControl(const AdaptivityParameters &adaptivity)
      : goal(adaptivity)
      , target(adaptivity.target())
    {}

    virtual ~AdaptationControl() = default;

    /// Why the analysis ends with this cycle; empty when it goes on.
    virtual std::optional<Outcome>
    check(const CycleResult &result)
    {
      if (!goal.adaptivity.is_adaptive() || !result.error_ratios)
        return Outcome::single_mesh;
      if (const auto outcome = goal.outcome(result))
        return outcome;
      if (result.cycle == goal.adaptivity.maximum_cycles)
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
      return goal.error_ratios(cycle, target);
    }

  protected:
    const Goal goal;
    double     target;
  };
} // namespace PlateImpact
