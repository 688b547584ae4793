#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  /// Newmark's method for a transient of equal steps: eqs. 3-7 of the paper in
  /// increments d, which keep digits that the total form loses on small steps,
  ///   K* d = f_1 + c_2 f_0 - (1 + c_2) K z + c_1 M v,   K* = K + c_0 M.
  struct NewmarkScheme
  {
    /// The smallest number of steps, none longer than the scene's.
    NewmarkScheme(const TimeParameters     &time,
                  const ContactIntegration &integration)
      : beta(time.newmark_beta)
      , gamma(time.newmark_gamma)
      , integration(integration)
      , n_steps(
          std::max(1., std::ceil(time.end_time / time.time_step * (1 - 1e-9))))
      // the scene's own where the end time is a multiple of it, so that longer
      // transients take the same steps to the last digit
      , dt(std::abs(time.end_time / n_steps - time.time_step) <=
               1e-9 * (time.end_time / n_steps) ?
             time.time_step :
             time.end_time / n_steps)
      , c0(1. / (beta * dt * dt))
      , c1(1. / (beta * dt))
      , c2(1. / (2. * beta) - 1.)
    {}

    /// Of a linear system, but for the work of the load: average acceleration.
    bool
    conserves_energy() const
    {
      return beta == 0.25 && gamma == 0.5;
    }

    /// Of the error in the step: gamma other than 1/2 damps, to first order.
    unsigned int
    order() const
    {
      return gamma == 0.5 ? 2 : 1;
    }

    const double             beta, gamma;
    const ContactIntegration integration;
    const unsigned int       n_steps;
    const double             dt; ///< [s]
    const double             c0; ///< 1/(beta dt^2) [1/s^2]
    const double             c1; ///< 1/(beta dt) [1/s]
    const double             c2; ///< 1/(2 beta) - 1
  };
} // namespace PlateImpact
