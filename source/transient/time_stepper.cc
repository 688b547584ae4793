#include "plate_impact/transient/time_stepper.h"

#include <cmath>

namespace PlateImpact
{
  TimeStepper::TimeStepper(const TimeParameters     &time,
                           SemidiscreteSystem       &plate,
                           const Contact            &contact,
                           const ContactIntegration &integration,
                           const Impactor           &impactor)
    : scheme(time)
    , plate(plate)
    , integration(integration)
    , plate_stepper(scheme, plate)
    , impactor_stepper(scheme, contact, integration, impactor)
  {}



  void
  TimeStepper::advance()
  {
    const double known    = impactor_stepper.begin_step();
    const double free     = plate_stepper.begin_step(known);
    const double at_begin = integration.acts_at_begin() ? 1. : 0.;
    const double phi      = separated_at ?
           0. :
           impactor_stepper.contact_force(free,
                                     (1. + scheme.c2 * at_begin) *
                                       plate_stepper.unit_displacement());
    plate_stepper.end_step(at_begin * phi, phi);
    impactor_stepper.end_step(phi,
                              plate_stepper.displacement(),
                              plate_stepper.energy());
    if (!separated_at && is_out_of_reach())
      separated_at = state().time;
  }



  bool
  TimeStepper::is_out_of_reach()
  {
    // other schemes do not keep the energy that bounds the displacement
    if (!scheme.conserves_energy() || state().impactor_velocity > 0. ||
        state().impactor_displacement >= 0.)
      return false;
    // beyond round-off in the energy, however far the impactor has flown
    const double energy = (1. + 1e-6) * state().plate_energy;
    return -state().impactor_displacement >
      std::sqrt(2. * energy * plate.static_compliance());
  }



  std::optional<double>
  TimeStepper::separation_time() const
  {
    return separated_at;
  }



  unsigned int
  TimeStepper::n_steps() const
  {
    return scheme.n_steps;
  }



  const ContactState &
  TimeStepper::state() const
  {
    return impactor_stepper.state();
  }



  const Eigen::VectorXd &
  TimeStepper::displacement() const
  {
    return plate_stepper.unknowns();
  }



  double
  TimeStepper::impulse() const
  {
    return impactor_stepper.impulse();
  }



  unsigned int
  TimeStepper::n_contact_steps() const
  {
    return impactor_stepper.n_contact_steps();
  }



  Impact
  step_to_end(TimeStepper                             &stepper,
              const std::function<void(unsigned int)> &listener)
  {
    Impact result;
    result.history.reserve(stepper.n_steps() + 1);
    result.history.add(stepper.state());
    for (unsigned int step = 1; step <= stepper.n_steps(); ++step)
      {
        stepper.advance();
        result.history.add(stepper.state());
        if (listener)
          listener(step);
      }
    result.impulse         = stepper.impulse();
    result.n_contact_steps = stepper.n_contact_steps();
    result.separation_time = stepper.separation_time();
    return result;
  }
} // namespace PlateImpact
