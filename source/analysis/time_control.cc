#include "plate_impact/analysis/time_control.h"

#include "plate_impact/analysis/goal.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// Steps to a late peak, at least: with fewer the error of the step is not
    /// yet told (measured on random heavy impactors with 30 to 1000 steps).
    constexpr double fewest_steps_to_late_peak = 128.;

    /// Of the step chosen at first: below, the error is not the step's.
    constexpr double smallest_step = 1. / 64.;

    /// Of those with which the error of the peak can be estimated: on the next
    /// mesh the peak may come later.
    constexpr double most_steps = 0.5 * most_steps_to_peak;

    /// A peak that comes later in the window may not be the last.
    constexpr double latest_peak = 0.7;

    /// A window holds the time of a peak that is known this many times.
    constexpr double reserve = 1.5;

    /// And that of the end of a contact, which another mesh may have later.
    constexpr double past_contact = 1.1;
  } // namespace



  Window
  TimeControl::with_peak(const Window         &last,
                         const ContactHistory &history) const
  {
    if (!scene.adaptivity.is_for_peak_force())
      return last;
    const double peak = history.peak().time;
    Window       next{Extent::to_peak,
                last.step,
                std::max(last.to_peak, reserve * peak),
                last.whole};
    if (returns_of_waves(history) <= 1.)
      return next;
    // waves that return may bring a larger force as long as the contact lasts
    if (scene.time.end_time == 0.)
      next.extent = Extent::whole;
    else
      // of the first contact, and of that after which the impactor leaves
      for (const bool is_held : {false, true})
        if (const auto end = history.end_of_impact(is_held))
          next.to_peak = std::max(next.to_peak, past_contact * *end);
    return next;
  }



  std::optional<Window>
  TimeControl::next(const Window &last, const CycleResult &seen) const
  {
    if (!scene.adaptivity.is_for_peak_force())
      return {};
    const double peak = seen.history->peak().time;
    Window       next = last;
    if (last.extent == Extent::peak_search)
      {
        next.extent = Extent::to_peak;
        if (returns_of_waves(*seen.history) <= 1.)
          return next;
        next = with_peak(last, *seen.history);
        if (scene.time.step_is_chosen)
          next.step = std::min(next.step, peak / fewest_steps_to_late_peak);
        return next;
      }
    const bool is_end = is_whole(last, seen);
    if (!is_end && peak > latest_peak * seen.history->states.back().time)
      {
        next.to_peak *= 2.;
        return next;
      }
    next.step = wanted_step(last, seen, seen.mesh_error());
    if (next.step < last.step)
      return next;
    if (is_end || !AdaptationControl(scene.adaptivity).is_met(seen))
      return {};
    next.extent = Extent::whole;
    return next;
  }



  double
  TimeControl::wanted_step(const Window      &window,
                           const Observation &seen,
                           const double       mesh_error) const
  {
    // steps of a history that the mesh spoils tell little
    const double most =
      std::max(share_of_step * scene.adaptivity.target_peak_force_error,
               0.1 * mesh_error);
    // without an estimate the step is of the order of the rise
    const double error = seen.time_error.value_or(16. * most);
    if (!scene.time.step_is_chosen || error <= most ||
        window.step < smallest_step * scene.time.time_step)
      return window.step;
    const double halvings = std::ceil(std::log2(error / most)) /
      NewmarkScheme(scene.time, scene.contact.integration).order;
    const double shortest = seen.history->peak().time / most_steps;
    return std::max(window.step * std::exp2(-std::min(halvings, 2.)),
                    std::min(shortest, window.step));
  }



  Parameters
  TimeControl::impact(const Window &window,
                      PlateModel   &plate,
                      const bool    needs_states) const
  {
    Parameters result     = scene;
    result.time.time_step = window.step;
    if (window.extent != Extent::to_peak)
      return until_contact_ends(plate, result, needs_states, window.whole);
    // divides the scene's end time, where it has one
    const double dt     = result.time.end_time > 0. ?
          NewmarkScheme(result.time, scene.contact.integration).dt :
          window.step;
    const double wanted = dt * std::ceil(window.to_peak / dt);
    if (result.time.end_time == 0. || wanted < result.time.end_time)
      {
        result.time.time_step = dt;
        result.time.end_time  = wanted;
      }
    return result;
  }
} // namespace PlateImpact
