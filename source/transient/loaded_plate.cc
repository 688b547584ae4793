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
    /// Until when ripples are compared, over the time of a peak on them.
    constexpr double past_ripples = 1.1;



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



  DualLoads
  dual_loads(const ContactHistory &history,
             const NewmarkScheme  &scheme,
             const Contact        &contact,
             const Impactor       &impactor,
             const PlateResponse  &response)
  {
    const std::vector<ContactState> &states      = history.states;
    const ContactIntegration        &integration = scheme.integration;
    const Eigen::Index p = &history.peak() - states.data(); // step of the peak
    Eigen::VectorXd    compliance(p), phi(p);
    // d phi_k by the approaches at the begin (a) and at the end (b) of a step
    Eigen::VectorXd a = Eigen::VectorXd::Zero(p), b = a;
    Contact         followed = contact;
    double          at_peak  = 0.;
    for (Eigen::Index k = 0; k < p; ++k)
      {
        // the impactor's own: steps after one with the contact force 1
        const double in_steps =
          integration.acts_at_begin ? k + 0.5 : std::max(scheme.beta, 1. * k);
        compliance[k] = response.displacement(k) +
          scheme.dt * scheme.dt / impactor.mass * in_steps;
        const double begin = states[k].indentation,
                     end   = states[k + 1].indentation;
        phi[k]             = integration.force(followed, begin, end);
        if (phi[k] != 0.)
          b[k] = integration.stiffness(followed, begin, end, phi[k]) /
            followed.approach_derivative(end);
        // a mean force takes both ends alike
        if (phi[k] != 0. && integration.acts_at_begin)
          a[k] = integration.stiffness(followed, end, begin, phi[k]) /
            followed.approach_derivative(begin);
        at_peak = followed.stiffness(end) / followed.approach_derivative(end);
        followed.follow(end);
      }

    Eigen::VectorXd mu(p);
    double          y_after = 0.; // y = (R + R_m)^T mu of the step after
    for (Eigen::Index n = p - 1; n >= 0; --n)
      {
        const Eigen::Index n_after = p - 1 - n;
        const double       of_later =
          compliance.segment(1, n_after).dot(mu.tail(n_after));
        double right_hand_side = n == p - 1 ? at_peak : -a[n + 1] * y_after;
        right_hand_side -= b[n] * of_later;
        mu[n]   = right_hand_side / (1. + b[n] * compliance[0]);
        y_after = of_later + compliance[0] * mu[n];
      }
    return {phi, mu};
  }



  DualMotions
  dual_motions(const DualLoads     &loads,
               const NewmarkScheme &scheme,
               SemidiscreteSystem  &plate,
               const unsigned int   most_times)
  {
    // Forces act in the middle of their steps and displacements are read at the
    // end: motion and dual motion belong together at times whose sum is half a
    // step more than that of the peak.
    const Eigen::Index p      = loads.forces.size(),
                       stride = 1 + (p - 1) / most_times;
    const Eigen::Index first = p % stride, n_times = p / stride + 1;
    DualMotions        result;
    result.weight = stride;
    result.motion.setZero(plate.load.size(), n_times);
    result.dual = result.motion;

    step_under(loads.forces,
               scheme,
               plate,
               [&](const Eigen::Index step, const PlateMotion &motion) {
                 if (step % stride == first)
                   // stresses follow strains and, damped, their rates
                   result.motion.col(step / stride) =
                     motion.z + plate.damping * motion.v;
               });
    step_under(loads.weights.reverse(),
               scheme,
               plate,
               [&](const Eigen::Index step, const PlateMotion &motion) {
                 const auto column = [&](const Eigen::Index beside) {
                   return result.dual.col(n_times - 1 - beside / stride);
                 };
                 if (step % stride == 0 && step < p)
                   column(step) += 0.5 * motion.z;
                 if ((step - 1) % stride == 0)
                   column(step - 1) += 0.5 * motion.z;
               });
    return result;
  }



  LoadedPlate::LoadedPlate(const Parameters              &impact,
                           std::shared_ptr<RitzReduction> shared)
    : system(shared->system_for(impact))
    , parameters(impact)
    , scheme(impact.time, impact.contact.integration)
    , reduction(std::move(shared))
    , contact(make_contact(parameters))
    , impactor(make_impactor(parameters.impactor))
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



  double
  LoadedPlate::returns_of_waves(const double time) const
  {
    return time /
      make_zener_impact(parameters)
        .return_of_waves(geometry_of(parameters.plate).distance_to_edge);
  }



  std::optional<double>
  LoadedPlate::time_error(const ContactHistory &history) const
  {
    const double peak = history.peak_of_curve();
    if (peak <= 0. || history.rise_time() < 3.5 * scheme.dt)
      return {};
    const double time = history.peak().time;
    // of other humps or of waves that are back, which may be too low for humps
    const bool has_ripples =
      history.peak_is_on_ripples() || returns_of_waves(time) > 1.;
    // three states make a peak
    const double until =
      std::min(scheme.n_steps * scheme.dt,
               std::max(time + 3. * scheme.dt,
                        has_ripples ? past_ripples * time : 0.));
    ContactHistory doubled;
    try
      {
        doubled = in_longer_steps(2, system, until);
      }
    // a plate that stretches may need shorter ones
    catch (const ComputationError &)
      {
        return {};
      }
    double change = doubled.peak_of_curve() - peak;
    if (const unsigned int last = scheme.n_steps;
        time == history.states[last].time)
      // a force that grows to the end is compared where both have a state
      change =
        doubled.states[last / 2].force - history.states[last - last % 2].force;
    change = std::abs(change);
    // such a peak may change little by accident where the ripples change much,
    // and these by less than the order tells while their phases do: 1.8 is
    // chosen on random heavy impactors
    if (has_ripples)
      change = std::max(change, 1.8 * doubled.difference_around(time, history));
    const double by_step = change / (std::exp2(scheme.order) - 1.),
                 missed  = peak - history.peak().force;
    return (by_step + missed) / peak;
  }



  ContactHistory
  LoadedPlate::on_other_plate(SemidiscreteSystem   &other,
                              const ContactHistory &history) const
  {
    const double peak = history.peak().time;
    // a difference needs no steps as small as the force itself
    return in_longer_steps(std::max(1., peak / (4000. * scheme.dt)),
                           other,
                           past_ripples * peak);
  }



  ContactHistory
  LoadedPlate::in_longer_steps(const unsigned int  factor,
                               SemidiscreteSystem &plate,
                               const double        until) const
  {
    TimeParameters longer = parameters.time;
    longer.time_step      = factor * scheme.dt;
    longer.end_time =
      longer.time_step * std::ceil(until / longer.time_step * (1. - 1e-9));
    TimeStepper stepper({longer, scheme.integration}, plate, contact, impactor);
    for (unsigned int n = 0; n < stepper.scheme.n_steps; ++n)
      stepper.advance();
    return stepper.impact().history;
  }



  std::optional<Sensitivity>
  LoadedPlate::sensitivity(const ContactHistory &history) const
  {
    // a plate with large deflections would have to be stepped once more
    if (history.n_contacts() < 2 || !system.is_linear)
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
    for (std::size_t step = 0; step < history.states.size(); ++step)
      {
        const ContactState &state = history.states[step];
        const double        changed =
          std::abs(other.states[step].force - state.force) / peak;
        result.factor = std::max(result.factor, changed / change);
        if (changed > unpredictable && !result.unpredictable_from)
          result.unpredictable_from = state.time;
      }
    return result;
  }



  std::optional<PeakForceProblem>
  LoadedPlate::peak_force_problem(const ContactHistory &history) const
  {
    const double peak = history.peak().time;
    if (!scheme.conserves_energy || !system.is_linear ||
        history.peak().force <= 0. || peak > most_steps_to_peak * scheme.dt)
      return {};
    const double        returns  = returns_of_waves(peak);
    const PlateGeometry geometry = geometry_of(parameters.plate);
    TimeParameters      to_peak  = parameters.time;
    to_peak.time_step            = scheme.dt;
    to_peak.end_time             = scheme.dt * std::round(peak / scheme.dt);
    const NewmarkScheme rise(to_peak, scheme.integration);
    // on the mesh it would take three more transients up to the peak
    std::unique_ptr<RitzReduction> own;
    if (is_stepped_on_the_mesh())
      {
        to_peak.integrator = IntegratorType::Ritz_vectors;
        if (returns > 1.)
          to_peak.end_time =
            scheme.dt * std::round(past_ripples * peak / scheme.dt);
        to_peak.ritz_tolerance = 1e-2; // vectors for the error alone
        own = std::make_unique<RitzReduction>(reduction->mesh,
                                              to_peak,
                                              scheme.integration,
                                              true);
      }
    RitzReduction      &used    = own ? *own : *reduction;
    SemidiscreteSystem &of_dual = used.system_for(parameters);
    const PlateResponse response(rise, of_dual);
    return PeakForceProblem{
      dual_motions(dual_loads(history, scheme, contact, impactor, response),
                   scheme,
                   of_dual,
                   // a motion takes half of what is looked at together
                   std::max(32u, of_dual.n_states_at_once() / 2)),
      &of_dual,
      std::move(own),
      returns,
      std::max(1.,
               returns * 2. * geometry.distance_to_edge /
                 std::sqrt(geometry.area))};
  }
} // namespace PlateImpact
