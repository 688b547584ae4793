#pragma once

#include "plate_impact/transient/full_system.h"

#include <vector>

namespace PlateImpact
{
  /// The lowest natural frequencies of a plate, K x = omega^2 M x, of motions
  /// with the symmetry of the part that is meshed but not as a rigid body, by
  /// Trilinos' Anasazi: block Krylov-Schur (Stewart 2002,
  /// doi:10.1137/S0895479800371529) with (K + c M)^{-1} M.
  /// @param matrices  is factorized anew
  /// @param n         how many; fewer where the mesh has less than four
  ///                  unknowns for each
  /// @return in ascending order [Hz]
  /// @throws ComputationError when they are not found or lost in round-off
  std::vector<double>
  natural_frequencies(EffectiveStiffness &matrices, unsigned int n);
} // namespace PlateImpact
