#pragma once

#include "plate_impact/contact/contact_solver.h"

namespace PlateImpact
{
  struct TimeParameters;

  /// Newmark's method for a transient of equal steps: a step advances the
  /// displacements by the increment d with
  ///   K* d = f_1 + c_2 f_0 - (1 + c_2) K z + c_1 M v,   K* = K + c_0 M
  /// (eqs. 3-7 of the paper in terms of increments, which keep digits that the
  /// total form loses on small steps). How the contact force acts within a step
  /// belongs to it.
  struct NewmarkScheme
  {
    /// The smallest number of steps, none longer than the scene's.
    NewmarkScheme(const TimeParameters     &time,
                  const ContactIntegration &integration);

    /// Whether the scheme keeps the energy of a linear system without load and
    /// charges it with the work of a load, (f_0 + f_1) d / 2: average
    /// acceleration.
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
