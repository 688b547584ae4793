#pragma once

#include "plate_impact/transient/full_system.h"

#include <vector>

namespace PlateImpact
{
  /// The lowest natural frequencies of a plate, of motions with the
  /// symmetry of the part that is meshed, as all that the impact excites:
  ///   K x = omega^2 M x,
  /// by Trilinos' Anasazi, block Krylov-Schur (Stewart 2002,
  /// doi:10.1137/S0895479800371529) with (K + c M)^{-1} M in the inner product
  /// of M. Motions as a rigid body are left out.
  /// @param matrices  is factorized anew
  /// @param n         how many; fewer where the mesh has less than four
  ///                  unknowns for each
  /// @return in ascending order [Hz]
  /// @throws ComputationError when they are not found or lost in round-off
  std::vector<double>
  natural_frequencies(EffectiveStiffness &matrices, unsigned int n);
} // namespace PlateImpact
