#include "plate_impact/transient/time_stepper.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"

#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{

  void
  TimeStepper::advance(const unsigned int n_steps)
  {
    const double at_begin = scheme.integration.acts_at_begin() ? 1. : 0.;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        std::optional<double> free =
          plate_motion->begin_step(impactor_stepper.begin_step());
        double phi = 0.;
        while (free)
          {
            phi = impactor_stepper.contact_force(
              *free,
              (1. + scheme.c2 * at_begin) * plate_motion->unit_displacement());
            free = end_plate_step(at_begin * phi, phi);
          }
        impactor_stepper.end_step(phi,
                                  plate_motion->displacement(),
                                  plate_motion->energy(),
                                  plate_motion->dissipated_energy());
        if (!impact().separation_time && is_out_of_reach())
          impactor_stepper.separate();
      }
  }



  std::optional<double>
  TimeStepper::end_plate_step(const double at_begin, const double at_end)
  {
    try
      {
        return plate_motion->end_step(at_begin, at_end);
      }
    catch (const ComputationError &error)
      {
        const double time = state().time + scheme.dt;
        throw ComputationError(fmt::format("step {} (t = {}): {}",
                                           std::lround(time / scheme.dt),
                                           number(time, "s"),
                                           error.what()));
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
