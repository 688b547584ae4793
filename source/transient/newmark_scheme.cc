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
  } // namespace



  NewmarkScheme::NewmarkScheme(const TimeParameters &time)
    : beta(time.newmark_beta)
    , gamma(time.newmark_gamma)
    , n_steps(count_steps(time))
    , dt(time.end_time / n_steps)
    , c0(1. / (beta * dt * dt))
    , c1(1. / (beta * dt))
    , c2(1. / (2. * beta) - 1.)
  {}
} // namespace PlateImpact
