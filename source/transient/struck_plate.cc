#include "plate_impact/transient/struck_plate.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/stage_clock.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/make_contact_law.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/linear_solver.h"
#include "plate_impact/transient/make_integrator.h"
#include "plate_impact/transient/natural_frequencies.h"
#include "plate_impact/transient/newmark_scheme.h"
#include "plate_impact/transient/time_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Numbers in the Ritz vectors of all loads that are kept: 0.8 GB.
    constexpr double most_kept_numbers = 1e8;



    /// Steps to the peak with which its error is estimated.
    constexpr double most_steps_to_peak = 20000.;

    /// Of the force by Ritz vectors that serve its error alone.
    constexpr double tolerance_of_estimate = 1e-2;

    /// Steps in which the end of a contact is looked for.
    constexpr double most_steps_of_contact = 262144.;



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
                           std::unique_ptr<dealii::Triangulation<2>> part)
    : element(discretization.element)
    , mesh(std::move(part))
    , linear_solver(discretization.linear_solver)
    , plate(*mesh, element, plate)
  {}



  Impact
  StruckPlate::strike(const Parameters &parameters)
  {
    Load               &load   = prepare(parameters);
    SemidiscreteSystem &system = load.integrator->system_for(parameters);
    Impact              result =
      strike_system(load,
                    system,
                    parameters.time,
                    *make_contact_law(parameters, load.layer_constant),
                    make_impactor(parameters.impactor));
    result.is_reduced = &system != full.get();
    require_energy(parameters, result.history);
    return result;
  }



  Parameters
  StruckPlate::until_contact_ends(const Parameters &parameters)
  {
    if (parameters.time.end_time > 0.)
      return parameters;
    Parameters result         = parameters;
    result.time.end_is_chosen = true;
    const double dt           = parameters.time.time_step;
    const double expected     = 2. * zener_peak(parameters).time;
    // by powers of two, so that impactors share vectors
    for (double n = std::exp2(std::ceil(std::log2(1.5 * expected / dt)));;
         n *= 2.)
      {
        result.time.horizon = result.time.end_time = n * dt;
        if (is_stepped_on_the_mesh(result))
          {
            // more steps take more vectors
            result.time.integrator = IntegratorType::Newmark;
            result.time.end_time   = end_by_steps(result);
            return result;
          }
        const std::optional<double> end =
          strike(result).history.first_contact_end();
        if (end)
          result.time.end_time = dt * std::ceil(*end / dt);
        if (end || n >= most_steps_of_contact ||
            n * dt >= longest_contact(parameters))
          return result;
      }
  }



  bool
  StruckPlate::is_stepped_on_the_mesh(const Parameters &parameters)
  {
    return &prepare(parameters).integrator->system_for(parameters) ==
      full.get();
  }



  double
  StruckPlate::end_by_steps(const Parameters &parameters)
  {
    const double dt = parameters.time.time_step;
    // few digits are needed, but every step counts
    TimeParameters coarse = parameters.time;
    coarse.time_step *= 4.;
    coarse.end_time = dt *
      std::ceil(std::min(
        most_steps_of_contact,
        std::max(parameters.time.end_time, longest_contact(parameters)) / dt));
    Load       &load = prepare(parameters);
    const auto  law  = make_contact_law(parameters, load.layer_constant);
    TimeStepper stepper(coarse,
                        *full,
                        *law,
                        *load.integration,
                        make_impactor(parameters.impactor));
    bool        is_touching = false;
    for (unsigned int step = 0; step < stepper.n_steps(); ++step)
      {
        stepper.advance();
        const ContactState &state = stepper.state();
        if (is_touching && state.force == 0.)
          return dt * std::ceil(1.01 * state.time / dt);
        is_touching = is_touching || state.force > 0.;
      }
    return coarse.end_time;
  }



  double
  StruckPlate::longest_contact(const Parameters &parameters)
  {
    const double half_space = 2. *
      rigid_plate_peak(*make_half_space_law(parameters),
                       make_impactor(parameters.impactor),
                       PlateSection(parameters.plate))
        .time;
    const double compliance = assembled().static_compliance();
    const double mass       = make_impactor(parameters.impactor).mass;
    if (!std::isfinite(compliance)) // free to move, it is left sooner
      return 100. * half_space;
    return 2. * (half_space + std::acos(-1.) * std::sqrt(mass * compliance));
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
    Impact result     = step_to_end(stepper, [&](const unsigned int step) {
      listener.take_step(step, stepper);
    });
    result.is_reduced = &system != full.get();
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
    const NewmarkScheme scheme(time);
    if (scheme.conserves_energy())
      return load.integrator->response(system).impact(law,
                                                      impactor,
                                                      scheme.n_steps);
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
    // the weights take the square of the steps
    if (history.peak().time > most_steps_to_peak * scheme.dt)
      return {};
    Load       &load       = prepare(parameters);
    Integrator *integrator = load.integrator.get();
    // On the mesh it would take three more transients up to the peak. It needs
    // few digits.
    if (&integrator->system_for(parameters) == full.get())
      {
        Parameters for_estimate          = parameters;
        for_estimate.time.integrator     = IntegratorType::Ritz_vectors;
        for_estimate.time.end_time       = history.peak().time;
        for_estimate.time.horizon        = 0.;
        for_estimate.time.time_step      = scheme.dt;
        for_estimate.time.ritz_tolerance = tolerance_of_estimate;
        for_one_estimate =
          make_integrator(for_estimate, *full, *load.integration);
        integrator = for_one_estimate.get();
      }
    SemidiscreteSystem  &system   = integrator->system_for(parameters);
    const PlateResponse &response = integrator->response(system);
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



  double
  StruckPlate::finest_cell_under_load(const Parameters &parameters) const
  {
    const ContactParameters &contact = parameters.contact;
    return cell_sizes_near_load(*mesh,
                                parameters.impactor.contact_half_length(),
                                contact.has_patch() ? contact.patch_radius : 0.)
      .first;
  }



  StruckPlate::Load &
  StruckPlate::prepare(const Parameters &parameters)
  {
    if (for_one_estimate != nullptr)
      n_forgotten_vectors += for_one_estimate->n_vectors();
    for_one_estimate.reset();
    FullSystem   &system = assembled();
    StageClock    clock;
    const LoadKey key   = load_key(parameters);
    auto          known = loads.find(key);
    if (known == loads.end())
      {
        forget_loads();
        Load load;
        load.u = plate.load(
          on_meshed_part(make_load_distribution(parameters.contact,
                                                parameters.impactor.length,
                                                finest_cell_under_load(
                                                  parameters)),
                         parameters.plate),
          load_rotation_factor(parameters.plate, parameters.contact));
        load.layer_constant =
          PlateImpact::layer_constant(parameters.plate, parameters.contact);
        load.integration =
          make_contact_integration(parameters.contact.integration);
        Parameters to_horizon = parameters;
        to_horizon.time.end_time =
          std::max(parameters.time.end_time, parameters.time.horizon);
        load.integrator =
          make_integrator(to_horizon, system, *load.integration);
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
    if (numbers <= most_kept_numbers)
      return;
    for (const auto &[key, load] : loads)
      n_forgotten_vectors += load.integrator->n_vectors();
    loads.clear();
  }



  StruckPlate::LoadKey
  StruckPlate::load_key(const Parameters &parameters)
  {
    ContactParameters contact    = parameters.contact;
    contact.law                  = {}; // whatever it is
    contact.unloading            = {};
    contact.critical_indentation = 0.;
    TimeParameters time          = parameters.time;
    time.end_time                = std::max(time.end_time, time.horizon);
    return {contact,
            parameters.impactor.shape,
            parameters.impactor.length,
            time,
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
    if (for_one_estimate != nullptr)
      work.ritz_vectors += for_one_estimate->n_vectors();
    if (full != nullptr)
      {
        work.factorizations        = full->n_factorizations();
        work.linear_solves         = full->n_solves();
        work.factorization_seconds = full->factorization_seconds();
      }
    return work;
  }
} // namespace PlateImpact
