#include "plate_impact/transient/impactor_stepper.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"

#include <cmath>
#include <fmt/format.h>
#include <string>
#include <utility>

namespace PlateImpact
{
  ImpactorStepper::ImpactorStepper(const NewmarkScheme &scheme,
                                   const Contact       &contact,
                                   const Impactor      &impactor)
    : scheme(scheme)
    , contact(contact)
    , impactor(impactor)
  {
    current.impactor_velocity = impactor.velocity;
    current.impactor_energy   = impactor.kinetic_energy();
    so_far.history.reserve(scheme.n_steps + 1);
    so_far.history.add(current);
  }



  double
  ImpactorStepper::begin_step()
  {
    ++step;
    begin_force = scheme.integration.known_begin_force(current.force);
    return begin_force;
  }



  double
  ImpactorStepper::contact_force(const double plate_free,
                                 const double plate_compliance) const
  {
    if (so_far.separation_time)
      return 0.;
    const double beta = scheme.beta, dt = scheme.dt;
    const double impactor_free = impactor.displacement +
      dt * impactor.velocity -
      dt * dt / impactor.mass * (0.5 - beta) * begin_force;
    const double at_begin   = scheme.integration.acts_at_begin() ? 1. : 0.;
    const double compliance = plate_compliance +
      dt * dt / impactor.mass * (beta + (0.5 - beta) * at_begin);
    try
      {
        return solve_contact(scheme.integration,
                             contact,
                             current.indentation,
                             impactor_free - plate_free,
                             compliance);
      }
    catch (const ComputationError &error)
      {
        throw ComputationError("step " + std::to_string(step) + ": " +
                               error.what());
      }
  }



  void
  ImpactorStepper::end_step(const double phi,
                            const double plate_displacement,
                            const double plate_energy,
                            const double plate_dissipated)
  {
    const double beta = scheme.beta, gamma = scheme.gamma, dt = scheme.dt;
    const double begin =
      begin_force + (scheme.integration.acts_at_begin() ? phi : 0.);
    impactor.displacement += dt * impactor.velocity -
      dt * dt / impactor.mass * ((0.5 - beta) * begin + beta * phi);
    const double impulse = dt * ((1. - gamma) * begin + gamma * phi);
    impactor.velocity -= impulse / impactor.mass;
    so_far.impulse += impulse;
    if (phi != 0.)
      ++so_far.n_contact_steps;

    current.time                  = dt * step;
    current.plate_displacement    = plate_displacement;
    current.impactor_displacement = impactor.displacement;
    current.impactor_velocity     = impactor.velocity;
    current.indentation =
      contact.indentation_under(impactor.displacement - plate_displacement);
    current.force             = contact.force(current.indentation);
    current.plate_energy      = plate_energy;
    current.contact_energy    = contact.stored_energy(current.indentation);
    current.impactor_energy   = impactor.kinetic_energy();
    current.dissipated_energy = contact.dissipated_energy(current.indentation);
    current.plate_dissipated_energy = plate_dissipated;
    for (const auto &[value, quantity] :
         {std::pair(current.plate_displacement, "plate displacement"),
          std::pair(current.total_energy(), "total energy")})
      if (!std::isfinite(value))
        throw ComputationError(fmt::format(
          "step {} (t = {} s): the {} is not finite ({}); try a smaller "
          "Time/Time step",
          step,
          current.time,
          quantity,
          value));
    if (current.force > contact.largest_force())
      throw ComputationError(fmt::format(
        "step {} (t = {}): the contact force, {}, is beyond the limit of the "
        "local response of a layer, {}; choose Contact/Patch radius = 0 or, if "
        "it is 0 already, Contact/Local response = half-space",
        step,
        number(current.time, "s"),
        number(current.force, "N"),
        number(contact.largest_force(), "N")));
    contact.follow(current.indentation);
    current.permanent_indentation = contact.dent();
    so_far.history.add(current);
  }
} // namespace PlateImpact
