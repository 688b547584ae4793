#include "plate_impact/time_error.h"

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



  double
  estimated_time_error(const ContactHistory     &history,
                       const TimeParameters     &time,
                       SemidiscretePlate        &plate,
                       const ContactLaw         &law,
                       const ContactIntegration &integration,
                       const Impactor           &impactor)
  {
    TimeParameters coarse = time;
    coarse.time_step = std::min(2. * history.states()[1].time, time.end_time);
    TimeStepper  stepper(coarse, plate, law, integration, impactor);
    const double coarse_peak = history_to_end(stepper).peak_of_curve();
    const double peak        = history.peak_of_curve();
    const double changed     = std::abs(coarse_peak - peak) / 3.,
                 missed      = peak - history.peak().force;
    return peak > 0. ? (changed + missed) / peak : 0.;
  }
} // namespace PlateImpact
