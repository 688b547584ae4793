#include "plate_impact/transient/time_error.h"

#include "plate_impact/transient/newmark_scheme.h"
#include "plate_impact/transient/time_stepper.h"

#include <cmath>

namespace PlateImpact
{
  std::optional<double>
  estimated_time_error(const ContactHistory     &history,
                       const TimeParameters     &time,
                       SemidiscreteSystem       &plate,
                       const Contact            &contact,
                       const ContactIntegration &integration,
                       const Impactor           &impactor)
  {
    const double        peak = history.peak_of_curve();
    const NewmarkScheme fine(time);
    if (peak <= 0. || history.rise_time() < 3.5 * fine.dt)
      return {};
    TimeParameters coarse = time;
    coarse.time_step      = 2. * fine.dt;
    coarse.end_time       = coarse.time_step * ((fine.n_steps + 1) / 2);
    TimeStepper    stepper(coarse, plate, contact, integration, impactor);
    ContactHistory doubled;
    doubled.add(stepper.state());
    // three states make a peak
    const double past_peak = history.peak().time + 1.5 * coarse.time_step;
    for (unsigned int step = 0;
         step < stepper.n_steps() && stepper.state().time < past_peak;
         ++step)
      {
        stepper.advance();
        doubled.add(stepper.state());
      }
    double change = doubled.peak_of_curve() - peak;
    if (const unsigned int last = fine.n_steps;
        history.peak().time == history.states()[last].time)
      // a force that grows to the end is compared where both have a state
      change = doubled.states()[last / 2].force -
        history.states()[last - last % 2].force;
    const double by_step = std::abs(change) / (std::exp2(fine.order()) - 1.),
                 missed  = peak - history.peak().force;
    return (by_step + missed) / peak;
  }
} // namespace PlateImpact
