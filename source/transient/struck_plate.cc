#include "plate_impact/transient/struck_plate.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/stage_clock.h"
#include "plate_impact/base/text.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/transient/linear_solver.h"
#include "plate_impact/transient/make_integrator.h"
#include "plate_impact/transient/natural_frequencies.h"
#include "plate_impact/transient/newmark_scheme.h"
#include "plate_impact/transient/time_error.h"

#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Numbers in the Ritz vectors of all loads that are kept: 0.8 GB.
    constexpr double most_numbers = 1e8;



    /// Steps to the peak with which its error is estimated.
    constexpr double most_steps_to_peak = 20000.;



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



  StruckPlate::StruckPlate(const PlateParameters          &plate,
                           const DiscretizationParameters &discretization,
                           std::unique_ptr<dealii::Triangulation<2>> quadrant)
    : element(discretization.element)
    , mesh(std::move(quadrant))
    , linear_solver(discretization.linear_solver)
    , plate(*mesh, element, plate)
  {}



  Impact
  StruckPlate::strike(const Parameters &parameters)
  {
    Load        &load = prepare(parameters);
    const Impact result =
      strike_system(load,
                    load.integrator->system_for(parameters),
                    parameters.time,
                    *make_contact_law(parameters, load.layer_constant),
                    make_impactor(parameters.impactor));
    require_energy(parameters, result.history);
    return result;
  }



  Impact
  StruckPlate::strike(const Parameters &parameters, TransientListener &listener)
  {
    Load               &load   = prepare(parameters);
    SemidiscreteSystem &system = load.integrator->system_for(parameters);
    const auto          law = make_contact_law(parameters, load.layer_constant);
    TimeStepper         stepper(parameters.time,
                        system,
                        *law,
                        *load.integration,
                        make_impactor(parameters.impactor));
    listener.begin(system, stepper);
    Impact result = step_to_end(stepper, [&](const unsigned int step) {
      listener.take_step(step, stepper);
    });
    require_energy(parameters, result.history);
    return result;
  }



  Impact
  StruckPlate::strike_system(Load                 &load,
                             SemidiscreteSystem   &system,
                             const TimeParameters &time,
                             const ContactLaw     &law,
                             const Impactor       &impactor)
  {
    if (NewmarkScheme(time).conserves_energy())
      return load.integrator->response(system).impact(law, impactor);
    TimeStepper stepper(time, system, law, *load.integration, impactor);
    return step_to_end(stepper);
  }



  std::optional<double>
  StruckPlate::time_error(const Parameters     &parameters,
                          const ContactHistory &history)
  {
    Load &load = prepare(parameters);
    return estimated_time_error(history,
                                parameters.time,
                                load.integrator->system_for(parameters),
                                *make_contact_law(parameters,
                                                  load.layer_constant),
                                *load.integration,
                                make_impactor(parameters.impactor));
  }



  std::optional<Sensitivity>
  StruckPlate::sensitivity(const Parameters     &parameters,
                           const ContactHistory &history)
  {
    if (history.n_contacts() < 2)
      return {};
    Load               &load   = prepare(parameters);
    SemidiscreteSystem &system = load.integrator->system_for(parameters);
    const auto          law = make_contact_law(parameters, load.layer_constant);
    return sensitivity_to_velocity(
      history,
      make_impactor(parameters.impactor),
      [&](const Impactor &other) {
        return strike_system(load, system, parameters.time, *law, other)
          .history;
      });
  }



  std::optional<StruckPlate::PeakForceProblem>
  StruckPlate::peak_force_problem(const Parameters     &parameters,
                                  const ContactHistory &history)
  {
    const NewmarkScheme scheme(parameters.time);
    if (!scheme.conserves_energy() || history.peak().force <= 0.)
      return {};
    Load               &load   = prepare(parameters);
    SemidiscreteSystem &system = load.integrator->system_for(parameters);
    // On the mesh it takes two more transients, and the weights take the square
    // of the steps.
    const bool is_wanted =
      parameters.adaptivity.goal == AdaptationGoal::peak_force;
    if ((&system == full.get() && !is_wanted) ||
        history.peak().time > most_steps_to_peak * scheme.dt)
      return {};
    const PlateResponse &response = load.integrator->response(system);
    const auto  law         = make_contact_law(parameters, load.layer_constant);
    const auto &integration = *load.integration;
    // a motion takes half of what is looked at together
    const unsigned int most_times =
      std::max(32u, system.n_states_at_once() / 2);
    return PeakForceProblem{
      dual_motions(forces_to_peak(history, *law, integration),
                   peak_force_weights(history,
                                      scheme,
                                      *law,
                                      integration,
                                      make_impactor(parameters.impactor),
                                      response),
                   scheme,
                   integration,
                   system,
                   most_times),
      &system};
  }



  std::vector<double>
  StruckPlate::natural_frequencies(const unsigned int n)
  {
    if (n == 0)
      return {};
    return PlateImpact::natural_frequencies(plate, assembled(), n);
  }



  FullSystem &
  StruckPlate::assembled()
  {
    if (full == nullptr)
      {
        StageClock clock;
        plate.assemble();
        full = std::make_unique<FullSystem>(plate,
                                            Eigen::VectorXd(),
                                            make_linear_solver(linear_solver));
        clock.charge(assembly_seconds);
      }
    return *full;
  }



  StruckPlate::Load &
  StruckPlate::prepare(const Parameters &parameters)
  {
    FullSystem   &system = assembled();
    StageClock    clock;
    const LoadKey key   = load_key(parameters);
    auto          known = loads.find(key);
    if (known == loads.end())
      {
        forget_loads();
        Load load;
        load.u = plate.load(make_load_distribution(parameters.contact,
                                                   parameters.impactor.length),
                            load_rotation_factor(parameters.plate,
                                                 parameters.contact));
        load.layer_constant =
          PlateImpact::layer_constant(parameters.plate, parameters.contact);
        load.integration =
          make_contact_integration(parameters.contact.integration);
        load.integrator =
          make_integrator(parameters, system, *load.integration);
        known = loads.emplace(key, std::move(load)).first;
        ++n_loads;
      }
    system.set_load(known->second.u);
    clock.charge(assembly_seconds);
    return known->second;
  }



  void
  StruckPlate::forget_loads()
  {
    double numbers = 0.;
    for (const auto &[key, load] : loads)
      numbers += 1. * load.integrator->n_vectors() * load.u.size();
    if (numbers <= most_numbers)
      return;
    for (const auto &[key, load] : loads)
      n_forgotten_vectors += load.integrator->n_vectors();
    loads.clear();
  }



  StruckPlate::LoadKey
  StruckPlate::load_key(const Parameters &parameters)
  {
    ContactParameters contact = parameters.contact;
    contact.law               = {}; // whatever it is
    return {contact,
            parameters.impactor.shape,
            parameters.impactor.length,
            parameters.time,
            parameters.needs_estimator()};
  }



  const PlateDiscretization &
  StruckPlate::discretization() const
  {
    return plate;
  }



  StruckPlate::Work
  StruckPlate::work() const
  {
    Work work;
    work.loads            = n_loads;
    work.ritz_vectors     = n_forgotten_vectors;
    work.assembly_seconds = assembly_seconds;
    for (const auto &[key, load] : loads)
      work.ritz_vectors += load.integrator->n_vectors();
    if (full != nullptr)
      {
        work.factorizations        = full->n_factorizations();
        work.linear_solves         = full->n_solves();
        work.factorization_seconds = full->factorization_seconds();
      }
    return work;
  }
} // namespace PlateImpact
