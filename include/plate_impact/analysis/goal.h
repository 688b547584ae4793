#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/base/choices.h"
#include "plate_impact/base/parameters.h"

#include <cmath>
#include <functional>
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
    not_verified,
    time_budget,
    minimum_cell_size,
    nearly_as_fine_as_the_reference
  };

  template <>
  const std::vector<Word<Outcome>> Choices<Outcome>::words;


  /// By how much the number of cells grows for an error of a late peak that is
  /// this factor smaller: with cells halved it falls to a ninth, the median of
  /// random heavy impactors (doc/make/error_bars.py).
  inline double
  growth_for_late_peak(const double factor)
  {
    return std::pow(factor, std::log(4.) / std::log(9.));
  }

  /// What a mesh of equal cells is made for, by the target: half of the meshes
  /// that are made for the target itself miss it.
  constexpr double aim_for_late_peak = 0.6;


  /// Says in place of a target which cells are too large.
  using Marking = std::function<ErrorRatios(const Cycle &)>;


  /// What the meshes of an analysis are made for, and when it ends: the error
  /// of the stresses in the energy norm and xi' of every cell that may still be
  /// refined (Table 1 of the paper), or the error bar of the peak force; by
  /// default down to the target of the scene.
  class AdaptationControl
  {
  public:
    explicit AdaptationControl(const AdaptivityParameters &adaptivity)
      : target(adaptivity.target())
      , adaptivity(adaptivity)
      , is_for_peak(adaptivity.goal == AdaptationGoal::peak_force)
    {}

    virtual ~AdaptationControl() = default;

    /// Why the analysis ends with this cycle; empty when it goes on.
    virtual std::optional<Outcome>
    check(const CycleResult &result)
    {
      if (!adaptivity.is_adaptive() || !result.error_ratios)
        return Outcome::single_mesh;
      if (const auto end = outcome(result))
        return end;
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

    /// Errors of the cells by what the target allows of them, for the next
    /// mesh.
    ErrorRatios
    error_ratios(const Cycle &cycle) const;

    Marking marking = {}; ///< in place of the target; empty: none

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

    /// Why the target is not met, and what helps; empty where it is.
    std::string
    warning(const CycleResult &result) const;

  protected:
    double target; ///< of the next mesh

  private:
    /// Whether there is what the scene asks for, or no mesh can have it; empty
    /// where a better mesh is to come.
    std::optional<Outcome>
    outcome(const CycleResult &result) const;

    const AdaptivityParameters adaptivity;
    const bool                 is_for_peak;
  };
} // namespace PlateImpact
