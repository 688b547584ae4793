#include "plate_impact/analysis/time_control.h"

#include "plate_impact/contact/zener.h"
#include "plate_impact/transient/newmark_scheme.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// Of the target, at most.
    constexpr double share_of_time = 0.3;

    /// Of the step chosen at first: below, it is not the step.
    constexpr double smallest_step = 1. / 64.;

    /// A peak that comes later in the window may not be the last.
    constexpr double latest_peak = 0.7;

    /// Step that divides the scene's end time, where it has one.
    double
    length_of_step(const TimeParameters &time)
    {
      return time.end_time > 0. ? NewmarkScheme(time).dt : time.time_step;
    }
  } // namespace



  TimeControl::TimeControl(const Parameters &parameters)
    : parameters(parameters)
    , is_for_peak(parameters.adaptivity.is_adaptive() &&
                  parameters.adaptivity.goal == AdaptationGoal::peak_force &&
                  parameters.has_impactor())
    , step(parameters.time.time_step)
    , is_whole(!is_for_peak)
  {
    if (!is_for_peak)
      return;
    window = 2.5 * zener_peak(parameters).time;
    echo   = 2. * parameters.plate.distance_to_edge() /
      contact_wave(parameters).group_speed;
    is_scouting = is_whole =
      parameters.time.end_time == 0. || parameters.time.end_time > echo;
  }



  Parameters
  TimeControl::next(StruckPlate &plate) const
  {
    Parameters result     = parameters;
    result.time.time_step = step;
    if (is_whole)
      return plate.until_contact_ends(result);
    const double dt     = length_of_step(result.time);
    const double wanted = dt * std::ceil(window / dt);
    if (result.time.end_time == 0. || wanted < result.time.end_time)
      {
        result.time.time_step = dt;
        result.time.end_time  = wanted;
      }
    return result;
  }



  bool
  TimeControl::refine_step(const std::optional<double> &time_error,
                           const double                 mesh_error)
  {
    // steps of a history that the mesh spoils tell little
    const double most =
      std::max(share_of_time * parameters.adaptivity.target_peak_force_error,
               0.1 * mesh_error);
    // without an estimate the step is of the order of the rise
    const double error = time_error.value_or(16. * most);
    if (!parameters.time.step_is_chosen || error <= most ||
        step < smallest_step * parameters.time.time_step)
      return false;
    const double halvings = std::ceil(std::log2(error / most)) /
      NewmarkScheme(parameters.time).order();
    step *= std::exp2(-std::min(halvings, 2.));
    return true;
  }



  bool
  TimeControl::goes_on(const ContactHistory        &history,
                       const std::optional<double> &time_error,
                       const double                 mesh_error,
                       const bool                   is_met)
  {
    if (!is_for_peak || history.peak().force <= 0.)
      return false;
    if (is_scouting)
      {
        is_scouting = is_whole = false;
        if (history.peak().time > echo)
          window = std::max(window, 1.5 * history.peak().time);
        return true;
      }
    const double end = history.states().back().time;
    // the end of the scene, where it has one
    const bool is_end = is_whole ||
      (parameters.time.end_time > 0. &&
       end >= (1. - 1e-9) * parameters.time.end_time);
    if (!is_end && history.peak().time > latest_peak * end)
      {
        window *= 2.;
        return true;
      }
    if (refine_step(time_error, mesh_error))
      return true;
    const bool is_longer = !is_end && is_met;
    is_whole             = is_end || is_met;
    return is_longer;
  }



  bool
  TimeControl::watch_to_the_end()
  {
    const bool was_whole = is_whole;
    is_whole             = true;
    return !was_whole;
  }



  void
  TimeControl::begin_mesh(const ContactHistory &history)
  {
    if (!is_for_peak)
      return;
    is_whole = false;
    window   = std::max(window, 1.5 * history.peak().time);
  }
} // namespace PlateImpact
