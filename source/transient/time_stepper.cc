#include "plate_impact/transient/time_stepper.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace PlateImpact
{
  TimeStepper::TimeStepper(const NewmarkScheme         &scheme,
                           SemidiscreteSystem          &plate,
                           const Contact               &contact,
                           const Impactor              &impactor,
                           std::unique_ptr<PlateMotion> motion)
    : scheme(scheme)
    , at_begin(scheme.integration.acts_at_begin ? 1. : 0.)
    , plate(motion == nullptr ? &plate : nullptr)
    , plate_motion(motion == nullptr ? plate.motion(scheme) : std::move(motion))
    , contact(contact)
    , impactor(impactor)
  {
    current.impactor_velocity = impactor.velocity;
    current.impactor_energy   = impactor.kinetic_energy();
    so_far.history.states.push_back(current);
  }



  void
  TimeStepper::advance(const unsigned int n_steps)
  {
    for (const unsigned int last = step + n_steps; step < last;)
      {
        throw_if_interrupted();
        ++step;
        begin_force = scheme.integration.acts_at_begin ? 0. : current.force;
        try
          {
            double phi = 0.;
            for (std::optional<double> free =
                   plate_motion->begin_step(begin_force);
                 free;)
              {
                phi  = contact_force(*free);
                free = plate_motion->end_step(at_begin * phi, phi);
              }
            end_step(phi);
          }
        catch (const ComputationError &error)
          {
            throw ComputationError(fmt::format("step {} (t = {}): {}",
                                               step,
                                               number(scheme.dt * step, "s"),
                                               error.what()));
          }
        // The plate can never reach the impactor again: without a force average
        // acceleration keeps its energy E, and the displacement under the load
        // stays within sqrt(2 E c), c the static compliance. Beyond round-off
        // in the energy, however far the impactor has flown.
        const double gap = -current.impactor_displacement;
        if (!so_far.separation_time && plate != nullptr &&
            scheme.conserves_energy && current.impactor_velocity <= 0. &&
            gap > 0. &&
            gap > std::sqrt(2. * (1. + 1e-6) * current.plate_energy *
                            plate->static_compliance()))
          so_far.separation_time = current.time;
      }
  }



  double
  TimeStepper::contact_force(const double plate_free) const
  {
    if (so_far.separation_time)
      return 0.;
    const double beta = scheme.beta, dt = scheme.dt;
    const double impactor_free = impactor.displacement +
      dt * impactor.velocity -
      dt * dt / impactor.mass * (0.5 - beta) * begin_force;
    const double compliance =
      (1. + scheme.c2 * at_begin) * plate_motion->w_of_unit_response +
      dt * dt / impactor.mass * (beta + (0.5 - beta) * at_begin);
    return solve_contact(scheme.integration,
                         contact,
                         current.indentation,
                         impactor_free - plate_free,
                         compliance);
  }



  void
  TimeStepper::end_step(const double phi)
  {
    const double beta = scheme.beta, gamma = scheme.gamma, dt = scheme.dt;
    const double begin = begin_force + at_begin * phi;
    impactor.displacement += dt * impactor.velocity -
      dt * dt / impactor.mass * ((0.5 - beta) * begin + beta * phi);
    const double impulse = dt * ((1. - gamma) * begin + gamma * phi);
    impactor.velocity -= impulse / impactor.mass;
    so_far.impulse += impulse;
    if (phi != 0.)
      ++so_far.n_contact_steps;

    current.time                  = dt * step;
    current.plate_displacement    = plate_motion->w;
    current.impactor_displacement = impactor.displacement;
    current.impactor_velocity     = impactor.velocity;
    current.indentation     = contact.indentation_under(impactor.displacement -
                                                    current.plate_displacement);
    current.force           = contact.force(current.indentation);
    current.plate_energy    = plate_motion->energy();
    current.contact_energy  = contact.stored_energy(current.indentation);
    current.impactor_energy = impactor.kinetic_energy();
    current.dissipated_energy = contact.dissipated_energy(current.indentation);
    current.plate_dissipated_energy = plate_motion->dissipated;
    for (const auto &[value, quantity] :
         {std::pair(current.plate_displacement, "plate displacement"),
          std::pair(current.total_energy(), "total energy")})
      if (!std::isfinite(value))
        throw ComputationError(
          fmt::format("the {} is not finite ({}); try a smaller Time/Time step",
                      quantity,
                      value));
    if (current.force > contact.largest_force)
      throw ComputationError(fmt::format(
        "the contact force, {}, is beyond the limit of the local response of a "
        "layer, {}; choose Contact/Patch radius = 0 or, if it is 0 already, "
        "Contact/Local response = half-space",
        number(current.force, "N"),
        number(contact.largest_force, "N")));
    contact.follow(current.indentation);
    current.permanent_indentation = contact.dent();
    so_far.history.states.push_back(current);
  }



  PlateResponse::PlateResponse(const NewmarkScheme &scheme,
                               SemidiscreteSystem  &plate)
    : reversed(scheme.n_steps)
    , forces(Eigen::VectorXd::Zero(scheme.n_steps))
  {
    step_under(Eigen::VectorXd::Unit(scheme.n_steps, 0),
               scheme,
               plate,
               [this](const Eigen::Index step, const PlateMotion &motion) {
                 reversed[reversed.size() - step] = motion.w;
               });
    if (!reversed.allFinite())
      throw ComputationError(
        "the response of the plate to a unit force is not finite; try a "
        "smaller Time/Time step");
    // the response has phi at the beginning of the step as well
    w_of_unit_response = displacement(0) /
      (scheme.integration.acts_at_begin ? 1. + scheme.c2 : 1.);
  }
} // namespace PlateImpact
