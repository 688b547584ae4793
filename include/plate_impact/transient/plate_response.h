#pragma once

#include "plate_impact/transient/time_stepper.h"

#include <Eigen/Core>

namespace PlateImpact
{
  /// All that an impactor needs to know of a plate: R_j, the displacement under
  /// the load j steps after a step with the contact force 1. Under the forces
  /// phi_k of any impactor
  ///   w_n = sum_{k <= n} R_{n-k} phi_k,
  /// a discrete Volterra equation of the second kind (Linz 1985,
  /// doi:10.1137/1.9781611970852): the recurrence of the time stepper, summed
  /// in another order. The plate's energy is the work of the force, which
  /// average acceleration makes equal.
  class PlateResponse
  {
  public:
    /// Steps the plate to the end time.
    /// @param scheme  conserves energy
    PlateResponse(const NewmarkScheme &scheme, SemidiscreteSystem &plate);

    /// R_j. [m/N]
    double
    displacement(const unsigned int j) const
    {
      return reversed[reversed.size() - 1 - j];
    }

    /// @param n_steps  at most those of the response
    /// @throws ComputationError naming step and quantity
    Impact
    impact(const Contact  &contact,
           const Impactor &impactor,
           unsigned int    n_steps) const;

  private:
    const NewmarkScheme scheme;
    Eigen::VectorXd     reversed; ///< R_{n_steps - 1} ... R_0 [m/N]
  };
} // namespace PlateImpact
