#include "plate_impact/time_error.h"

#include "plate_impact/newmark_scheme.h"
#include "plate_impact/time_stepper.h"
#include "plate_impact/zener.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  double
  chosen_time_step(const TimeParameters &time,
                   const ContactLaw     &law,
                   const Impactor       &impactor,
                   const PlateSection   &section)
  {
    const ExpectedPeak exact        = zener_peak(law, impactor, section);
    const double       contact_time = 2. * exact.time, pi = std::acos(-1.);
    // by powers of two from a time of the plate alone, the inverse frequency of
    // thickness shear, so that impactors share steps
    const double base =
      std::sqrt(section.rotary_inertia / section.shear_stiffness);
    double step =
      base * std::exp2(std::floor(std::log2(contact_time / 8. / base)));
    // the reference is good to about 1e-5
    const double tolerance = std::max(time.step_tolerance, 1e-5);
    while (true)
      {
        step *= 0.5;
        // the largest step misses the peak of a half sine by up to half a step
        const double missed  = 1. - std::cos(0.5 * pi * step / contact_time);
        const double changed = std::abs(
          zener_peak(law, impactor, section, step).force / exact.force - 1.);
        if (std::max(missed, changed) <= tolerance)
          return std::min(step, time.end_time);
      }
  }



  std::optional<double>
  estimated_time_error(const ContactHistory     &history,
                       const TimeParameters     &time,
                       SemidiscretePlate        &plate,
                       const ContactLaw         &law,
                       const ContactIntegration &integration,
                       const Impactor           &impactor,
                       unsigned int             &n_solves)
  {
    const double        peak = history.peak_of_curve();
    const NewmarkScheme fine(time);
    if (peak <= 0. || history.rise_time() < 3.5 * fine.dt)
      return {};
    TimeParameters coarse = time;
    coarse.time_step      = 2. * fine.dt;
    coarse.end_time       = coarse.time_step * ((fine.n_steps + 1) / 2);
    TimeStepper    stepper(coarse, plate, law, integration, impactor);
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
    n_solves += stepper.n_linear_solves();
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
