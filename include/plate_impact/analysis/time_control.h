#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/transient/plate_model.h"

#include <optional>

namespace PlateImpact
{
  /// How far a transient goes.
  enum class Extent
  {
    peak_search, ///< to its end, for the time of its peak only
    to_peak,     ///< no longer than the peak takes
    whole        ///< to its end
  };

  /// What is watched of an impact.
  struct Window
  {
    Extent extent  = Extent::whole;
    double step    = 0.; ///< [s]
    double to_peak = 0.; ///< length on the way to the peak [s]
    double whole   = 0.; ///< length where it was computed to its end [s]
  };


  /// The part of a target for the peak force that the time step may take.
  constexpr double share_of_step = 0.3;


  /// How long a plate is watched on a mesh and in which steps: with the goal
  /// `energy norm` as the scene says, on the way to a peak force no longer than
  /// the peak takes (doc/theory.md). Before waves are back from the edges a
  /// force has one peak, and a larger one later is the mesh's own; one after
  /// that is the impact's, and waves may bring a still larger one while the
  /// contact lasts.
  class TimeControl
  {
  public:
    /// @param scene  complete; with an impactor
    TimeControl(const Parameters &scene, const ZenerImpact &expected)
      : expected(expected)
      , scene(scene)
      , waves_are_back(
          expected.return_of_waves(geometry_of(scene.plate).distance_to_edge))
    {}

    /// The first window on the first mesh.
    Window
    first() const
    {
      const TimeParameters &time = scene.time;
      const bool            waves_return =
        time.end_time == 0. || time.end_time > waves_are_back;
      return {!scene.adaptivity.is_for_peak_force() ? Extent::whole :
                waves_return                        ? Extent::peak_search :
                                                      Extent::to_peak,
              time.time_step,
              2.5 * expected.peak.time}; // with some reserve
    }

    /// The window after one that has shown the time of the peak, the first on a
    /// finer mesh as well; to the end of the contact where the peak is late.
    Window
    with_peak(const Window &last, const ContactHistory &history) const;

    /// The next window on the same mesh, after what the last one has shown;
    /// empty where that is enough to judge the mesh.
    std::optional<Window>
    next(const Window &last, const CycleResult &seen) const;

    /// The step for a share of the target; that of the window where it keeps
    /// to it.
    /// @param mesh_error  of the peak force, relative to it
    double
    wanted_step(const Window      &window,
                const Observation &seen,
                double             mesh_error) const;

    /// Whether the window ended where the scene does.
    bool
    is_whole(const Window &window, const CycleResult &seen) const
    {
      const double end = scene.time.end_time; // 0 for that of the contact
      return window.extent == Extent::whole ||
        (end > 0. && seen.history->states.back().time >= (1. - 1e-9) * end);
    }

    /// How many times waves are back from the nearest edge before the peak.
    double
    returns_of_waves(const ContactHistory &history) const
    {
      return history.peak().time / waves_are_back;
    }

    /// The scene with the end time and the step of a window.
    /// @param needs_states  as for PlateModel::under()
    /// @throws ComputationError naming step and quantity
    Parameters
    impact(const Window &window, PlateModel &plate, bool needs_states) const;

    const ZenerImpact expected; ///< of the scene

  private:
    const Parameters scene;
    const double     waves_are_back; ///< when they are [s]
  };
} // namespace PlateImpact
