#include "plate_impact/transient/time_stepper.h"

#include <cmath>

namespace PlateImpact
{

  void
  TimeStepper::advance(const unsigned int n_steps)
  {
    const double at_begin = integration.acts_at_begin() ? 1. : 0.;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        const double free =
          plate_stepper.begin_step(impactor_stepper.begin_step());
        const double phi =
          impactor_stepper.contact_force(free,
                                         (1. + scheme.c2 * at_begin) *
                                           plate_stepper.unit_displacement());
        plate_stepper.end_step(at_begin * phi, phi);
        impactor_stepper.end_step(phi,
                                  plate_stepper.displacement(),
                                  plate_stepper.energy(),
                                  plate_stepper.dissipated_energy());
        if (!impact().separation_time && is_out_of_reach())
          impactor_stepper.separate();
      }
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
} // namespace PlateImpact
