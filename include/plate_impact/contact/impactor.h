#pragma once

namespace PlateImpact
{
  struct ImpactorParameters;

  /// The striking body as a point mass; towards the plate is positive. (The
  /// paper prints its displacement as the double integral of f/m; meant is v0 t
  /// minus that.)
  struct Impactor
  {
    double mass;         ///< [kg]
    double displacement; ///< since first touch [m]
    double velocity;     ///< [m/s]

    double
    kinetic_energy() const
    {
      return 0.5 * mass * velocity * velocity;
    }
  };

  /// The impactor of a scene at first touch.
  Impactor
  make_impactor(const ImpactorParameters &parameters);
} // namespace PlateImpact
