#include "plate_impact/transient/newmark_scheme.h"

#include "plate_impact/base/parameters.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    unsigned int
    count_steps(const TimeParameters &time)
    {
      const double ratio = time.end_time / time.time_step;
      return static_cast<unsigned int>(
        std::max(1., std::ceil(ratio * (1 - 1e-9))));
    }



    /// The scene's own where the end time is a multiple of it, so that a
    /// transient that goes on longer takes the same steps to the last digit.
    double
    length_of_steps(const TimeParameters &time, const unsigned int n_steps)
    {
      const double length = time.end_time / n_steps;
      return std::abs(length - time.time_step) <= 1e-9 * length ?
        time.time_step :
        length;
    }
  } // namespace



  NewmarkScheme::NewmarkScheme(const TimeParameters     &time,
                               const ContactIntegration &integration)
    : beta(time.newmark_beta)
    , gamma(time.newmark_gamma)
    , integration(integration)
    , n_steps(count_steps(time))
    , dt(length_of_steps(time, n_steps))
    , c0(1. / (beta * dt * dt))
    , c1(1. / (beta * dt))
    , c2(1. / (2. * beta) - 1.)
  {}
} // namespace PlateImpact
