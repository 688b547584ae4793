#include "plate_impact/transient/loaded_plate.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/make_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Until when longer steps are taken, over the time of a peak on ripples.
    constexpr double past_ripples = 1.1;

    /// Change of a peak over that of the ripples around it: covers 95 of 100
    /// random heavy impactors.
    constexpr double peak_over_ripples = 1.25;

    /// Of the force by Ritz vectors that serve its error alone.
    constexpr double tolerance_of_estimate = 1e-2;



    void
    require_energy(const Parameters &parameters, const ContactHistory &history)
    {
      const double drift = history.relative_energy_drift();
      if (drift <= 1e-6 ||
          parameters.contact.integration != ForceIntegration::energy_conserving)
        return;
      throw ComputationError(
        "the total energy, which the scheme keeps, changes by " +
        about_percentage(drift) +
        (parameters.time.integrator == IntegratorType::Newmark ?
           "" :
           "; try Time/Integrator = Newmark"));
    }
  } // namespace



  LoadedPlate::LoadedPlate(const Parameters              &impact,
                           std::shared_ptr<RitzReduction> shared)
    : parameters(impact)
    , scheme(impact.time, impact.contact.integration)
    , reduction(std::move(shared))
    , contact(make_contact(parameters))
    , impactor(make_impactor(parameters.impactor))
    , system(reduction->system_for(parameters))
  {}



  Impact
  LoadedPlate::strike() const
  {
    Impact result = reduction->impact(reduction->scheme,
                                      system,
                                      contact,
                                      impactor,
                                      scheme.n_steps);
    require_energy(parameters, result.history);
    return result;
  }



  Impact
  LoadedPlate::strike(
    const std::function<void(unsigned int, const TimeStepper &)> &take_step)
    const
  {
    TimeStepper stepper(scheme, system, contact, impactor);
    for (unsigned int step = 1; step <= scheme.n_steps; ++step)
      {
        stepper.advance();
        take_step(step, stepper);
      }
    require_energy(parameters, stepper.impact().history);
    return stepper.impact();
  }



  std::optional<double>
  LoadedPlate::time_error(const ContactHistory &history) const
  {
    const double peak = history.peak_of_curve();
    if (peak <= 0. || history.rise_time() < 3.5 * scheme.dt)
      return {};
    const double time = history.peak().time;
    // three states make a peak
    const bool   is_on_ripples = history.peak_is_on_ripples();
    const double until =
      std::max(time + 3. * scheme.dt, is_on_ripples ? past_ripples * time : 0.);
    const ContactHistory doubled = in_longer_steps(2, until);
    double               change  = doubled.peak_of_curve() - peak;
    if (const unsigned int last = scheme.n_steps;
        time == history.states()[last].time)
      // a force that grows to the end is compared where both have a state
      change = doubled.states()[last / 2].force -
        history.states()[last - last % 2].force;
    change       = std::abs(change);
    double decay = std::exp2(scheme.order()); // of changes, as steps halve
    if (is_on_ripples)
      {
        // such a peak may change little by accident where the ripples change
        // much, and these by less than the order tells while their phases do
        const ContactHistory fourfold = in_longer_steps(4, until);
        const double         around = doubled.difference_around(time, history),
                     before         = fourfold.difference_around(time, doubled),
                     change_before  = std::abs(fourfold.peak_of_curve() -
                                              doubled.peak_of_curve());
        change =
          std::max({change, change_before / 3., peak_over_ripples * around});
        if (before < decay * around)
          decay = std::max(2., before / around);
      }
    const double by_step = change / (decay - 1.),
                 missed  = peak - history.peak().force;
    return (by_step + missed) / peak;
  }



  ContactHistory
  LoadedPlate::in_longer_steps(const unsigned int factor,
                               const double       until) const
  {
    TimeParameters longer = parameters.time;
    longer.time_step      = factor * scheme.dt;
    longer.end_time =
      longer.time_step * ((scheme.n_steps + factor - 1) / factor);
    TimeStepper           stepper = steps(longer);
    const ContactHistory &history = stepper.impact().history;
    while (history.states().size() <= stepper.n_steps() &&
           stepper.state().time < until)
      stepper.advance();
    return history;
  }



  std::optional<Sensitivity>
  LoadedPlate::sensitivity(const ContactHistory &history) const
  {
    // a plate with large deflections would have to be stepped once more
    if (history.n_contacts() < 2 || !system.is_linear())
      return {};
    const double change = 1e-6, unpredictable = 1e-3;
    Impactor     faster = impactor;
    faster.velocity *= 1. + change;
    const ContactHistory other =
      reduction
        ->impact(reduction->scheme, system, contact, faster, scheme.n_steps)
        .history;
    const double peak = history.peak().force;
    Sensitivity  result;
    for (std::size_t step = 0; step < history.states().size(); ++step)
      {
        const ContactState &state = history.states()[step];
        const double        changed =
          std::abs(other.states()[step].force - state.force) / peak;
        result.factor = std::max(result.factor, changed / change);
        if (changed > unpredictable && !result.unpredictable_from)
          result.unpredictable_from = state.time;
      }
    return result;
  }



  std::optional<PeakForceProblem>
  LoadedPlate::peak_force_problem(const ContactHistory &history) const
  {
    if (!scheme.conserves_energy() || !system.is_linear() ||
        history.peak().force <= 0. ||
        history.peak().time > most_steps_to_peak * scheme.dt)
      return {};
    // on the mesh it would take three more transients up to the peak
    std::unique_ptr<RitzReduction> own;
    if (is_stepped_on_the_mesh())
      {
        TimeParameters to_peak = parameters.time;
        to_peak.integrator     = IntegratorType::Ritz_vectors;
        to_peak.end_time       = history.peak().time;
        to_peak.time_step      = scheme.dt;
        to_peak.ritz_tolerance = tolerance_of_estimate;
        own = std::make_unique<RitzReduction>(reduction->mesh,
                                              to_peak,
                                              scheme.integration,
                                              true);
      }
    RitzReduction       &used     = own ? *own : *reduction;
    SemidiscreteSystem  &of_dual  = used.system_for(parameters);
    const PlateResponse &response = used.response(used.scheme, of_dual);
    // a motion takes half of what is looked at together
    const unsigned int most_times =
      std::max(32u, of_dual.n_states_at_once() / 2);
    DualMotions motions =
      dual_motions(dual_loads(history, scheme, contact, impactor, response),
                   scheme,
                   of_dual,
                   most_times);
    return PeakForceProblem{std::move(motions), &of_dual, std::move(own)};
  }
} // namespace PlateImpact
