#pragma once

#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>

namespace PlateImpact
{
  /// Where the error is, by the jumps across the sides of cells instead of a
  /// recovered field (Kelly, Gago, Zienkiewicz & Babuska 1983,
  /// doi:10.1002/nme.1620191103; deal.II's KellyErrorEstimator):
  ///   eta_i^2 = h_i/24 sum over sides int (kappa G t [dw/dn]^2 + D
  ///   [dtheta/dn]^2),
  /// with the shear and bending stiffness, so that both jumps count as
  /// energies. The jumps only rank the cells: how large the error is together
  /// stays what EnergyNormEstimator says. For teaching what the recovery adds.
  /// @param states  unknowns of the plate, a column each
  /// @return eta_i by active index, a column per state, each times some factor
  Eigen::MatrixXd
  jumps_of_cells(const PlateDiscretization &discretization,
                 const Eigen::MatrixXd     &states);
} // namespace PlateImpact
