#include "plate_impact/transient/loaded_plate.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/transient/integrator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Steps to the peak with which its error is estimated: the weights take
    /// their square.
    constexpr double most_steps_to_peak = 20000.;

    /// The neighbourhood of a peak, on both sides of it, over its time.
    constexpr double neighbourhood = 0.1;

    /// Of the force by Ritz vectors that serve its error alone.
    constexpr double tolerance_of_estimate = 1e-2;



    /// Whether the force falls on the way to its peak: other humps lead there.
    bool
    peak_is_on_ripples(const ContactHistory &history)
    {
      const auto  &states = history.states();
      const double peak   = history.peak().time;
      for (std::size_t n = 1; n < states.size() && states[n].time <= peak; ++n)
        if (states[n].force < states[n - 1].force)
          return true;
      return false;
    }



    /// Root of the mean square of what the doubled step changes of the force in
    /// the neighbourhood of the peak. [N]
    double
    change_around_peak(const ContactHistory &history,
                       const ContactHistory &doubled)
    {
      const double  peak     = history.peak().time;
      double        squares  = 0.;
      std::uint64_t n_states = 0;
      for (std::size_t n = 1;
           n < doubled.states().size() && 2 * n < history.states().size();
           ++n)
        {
          const ContactState &state = history.states()[2 * n];
          if (std::abs(state.time - peak) > neighbourhood * peak)
            continue;
          const double change = doubled.states()[n].force - state.force;
          squares += change * change;
          ++n_states;
        }
      return n_states > 0 ? std::sqrt(squares / n_states) : 0.;
    }



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



  LoadedPlate::LoadedPlate(const Parameters     &impact,
                           std::shared_ptr<Load> shared_load)
    : parameters(impact)
    , scheme(impact.time)
    , load(std::move(shared_load))
    , contact(make_contact(parameters, load->layer_constant))
    , impactor(make_impactor(parameters.impactor))
    , system(load->integrator->system_for(parameters))
  {}



  TimeStepper
  LoadedPlate::steps(const NewmarkScheme &by, SemidiscreteSystem &stepped) const
  {
    return {by, stepped, contact, *load->integration, impactor};
  }



  Impact
  LoadedPlate::strike() const
  {
    Impact result =
      load->integrator->impact(system, contact, impactor, scheme.n_steps);
    require_energy(parameters, result.history);
    return result;
  }



  Impact
  LoadedPlate::strike(TransientListener &listener) const
  {
    TimeStepper stepper = steps(scheme, system);
    listener.begin(system, stepper);
    for (unsigned int step = 1; step <= scheme.n_steps; ++step)
      {
        stepper.advance();
        listener.take_step(step, stepper);
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
    TimeParameters coarse = parameters.time;
    coarse.time_step      = 2. * scheme.dt;
    coarse.end_time       = coarse.time_step * ((scheme.n_steps + 1) / 2);
    TimeStepper           stepper = steps(coarse, system);
    const ContactHistory &doubled = stepper.impact().history;
    // three states make a peak
    const bool   is_on_ripples = peak_is_on_ripples(history);
    const double past_peak =
      std::max(history.peak().time + 1.5 * coarse.time_step,
               is_on_ripples ? (1. + neighbourhood) * history.peak().time : 0.);
    while (doubled.states().size() <= stepper.n_steps() &&
           stepper.state().time < past_peak)
      stepper.advance();
    double change = doubled.peak_of_curve() - peak;
    if (const unsigned int last = scheme.n_steps;
        history.peak().time == history.states()[last].time)
      // a force that grows to the end is compared where both have a state
      change = doubled.states()[last / 2].force -
        history.states()[last - last % 2].force;
    // such a peak may change little by accident where the ripples change much
    if (is_on_ripples)
      change = std::max(std::abs(change), change_around_peak(history, doubled));
    const double by_step = std::abs(change) / (std::exp2(scheme.order()) - 1.),
                 missed  = peak - history.peak().force;
    return (by_step + missed) / peak;
  }



  std::optional<Sensitivity>
  LoadedPlate::sensitivity(const ContactHistory &history) const
  {
    if (history.n_contacts() < 2)
      return {};
    const double change = 1e-6, unpredictable = 1e-3;
    Impactor     faster = impactor;
    faster.velocity *= 1. + change;
    const ContactHistory other =
      load->integrator->impact(system, contact, faster, scheme.n_steps).history;
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



  std::unique_ptr<Integrator>
  LoadedPlate::integrator_to(const double time_of_peak) const
  {
    TimeParameters to_peak = parameters.time;
    to_peak.integrator     = IntegratorType::Ritz_vectors;
    to_peak.end_time       = time_of_peak;
    to_peak.time_step      = scheme.dt;
    to_peak.ritz_tolerance = tolerance_of_estimate;
    return make_integrator(load->system, to_peak, *load->integration, true);
  }



  std::optional<PeakForceProblem>
  LoadedPlate::peak_force_problem(const ContactHistory &history) const
  {
    if (!scheme.conserves_energy() || history.peak().force <= 0. ||
        history.peak().time > most_steps_to_peak * scheme.dt)
      return {};
    // on the mesh it would take three more transients up to the peak
    std::unique_ptr<Integrator> own;
    if (is_stepped_on_the_mesh())
      own = integrator_to(history.peak().time);
    Integrator          &integrator = own ? *own : *load->integrator;
    SemidiscreteSystem  &of_dual    = integrator.system_for(parameters);
    const PlateResponse &response   = integrator.response(of_dual);
    // a motion takes half of what is looked at together
    const unsigned int most_times =
      std::max(32u, of_dual.n_states_at_once() / 2);
    DualMotions motions =
      dual_motions(forces_to_peak(history, contact, *load->integration),
                   peak_force_weights(history,
                                      scheme,
                                      contact,
                                      *load->integration,
                                      impactor,
                                      response),
                   scheme,
                   *load->integration,
                   of_dual,
                   most_times);
    if (own)
      load->n_vectors_for_errors += own->n_vectors();
    return PeakForceProblem{std::move(motions), &of_dual, std::move(own)};
  }
} // namespace PlateImpact
