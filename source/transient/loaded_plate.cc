#include "plate_impact/transient/loaded_plate.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/transient/make_integrator.h"
#include "plate_impact/transient/newmark_scheme.h"
#include "plate_impact/transient/time_error.h"

#include <algorithm>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Steps to the peak with which its error is estimated: the weights take
    /// their square.
    constexpr double most_steps_to_peak = 20000.;

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



  LoadedPlate::LoadedPlate(const Parameters     &impact,
                           std::shared_ptr<Load> shared_load)
    : parameters(impact)
    , load(std::move(shared_load))
    , contact(make_contact(parameters, load->layer_constant))
    , impactor(make_impactor(parameters.impactor))
    , system(load->integrator->system_for(parameters))
  {}



  bool
  LoadedPlate::is_stepped_on_the_mesh() const
  {
    return &system == &load->system;
  }



  Impact
  LoadedPlate::strike() const
  {
    Impact result = strike(impactor);
    require_energy(parameters, result.history);
    return result;
  }



  Impact
  LoadedPlate::strike(const Impactor &striking) const
  {
    const NewmarkScheme scheme(parameters.time);
    Impact              result;
    if (scheme.conserves_energy())
      result = load->integrator->response(system).impact(contact,
                                                         striking,
                                                         scheme.n_steps);
    else
      {
        TimeStepper stepper(parameters.time,
                            system,
                            contact,
                            *load->integration,
                            striking);
        result = step_to_end(stepper);
      }
    result.is_reduced = !is_stepped_on_the_mesh();
    return result;
  }



  Impact
  LoadedPlate::strike(TransientListener &listener) const
  {
    TimeStepper stepper(parameters.time,
                        system,
                        contact,
                        *load->integration,
                        impactor);
    listener.begin(system, stepper);
    Impact result     = step_to_end(stepper, [&](const unsigned int step) {
      listener.take_step(step, stepper);
    });
    result.is_reduced = !is_stepped_on_the_mesh();
    require_energy(parameters, result.history);
    return result;
  }



  TimeStepper
  LoadedPlate::steps_on_the_mesh(const TimeParameters &time) const
  {
    return {time, load->system, contact, *load->integration, impactor};
  }



  double
  LoadedPlate::static_compliance() const
  {
    return load->system.static_compliance();
  }



  std::optional<double>
  LoadedPlate::time_error(const ContactHistory &history) const
  {
    return estimated_time_error(history,
                                parameters.time,
                                system,
                                contact,
                                *load->integration,
                                impactor);
  }



  std::optional<Sensitivity>
  LoadedPlate::sensitivity(const ContactHistory &history) const
  {
    if (history.n_contacts() < 2)
      return {};
    return sensitivity_to_velocity(history,
                                   impactor,
                                   [this](const Impactor &other) {
                                     return strike(other).history;
                                   });
  }



  std::optional<PeakForceProblem>
  LoadedPlate::peak_force_problem(const ContactHistory &history) const
  {
    const NewmarkScheme scheme(parameters.time);
    if (!scheme.conserves_energy() || history.peak().force <= 0. ||
        history.peak().time > most_steps_to_peak * scheme.dt)
      return {};
    // On the mesh it would take three more transients up to the peak. It needs
    // few digits.
    std::unique_ptr<Integrator> own;
    if (is_stepped_on_the_mesh())
      {
        TimeParameters to_peak = parameters.time;
        to_peak.integrator     = IntegratorType::Ritz_vectors;
        to_peak.end_time       = history.peak().time;
        to_peak.horizon        = 0.;
        to_peak.time_step      = scheme.dt;
        to_peak.ritz_tolerance = tolerance_of_estimate;
        own                    = make_integrator(to_peak,
                              parameters.plate,
                              load->system,
                              *load->integration,
                              true);
      }
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
