#pragma once

namespace PlateImpact
{
  struct ImpactorParameters;

  /// The striking body as a point mass: mass [kg], displacement since first
  /// touch [m] and velocity [m/s], both positive towards the plate. (The paper
  /// prints its displacement as the double integral of f/m; meant is v0 t minus
  /// that.)
  struct Impactor
  {
    double mass;
    double displacement;
    double velocity;

    double
    kinetic_energy() const
    {
      return 0.5 * mass * velocity * velocity;
    }
  };

  /// The impactor of a scene at first touch; its mass follows from density and
  /// shape where the scene gives none.
  Impactor
  make_impactor(const ImpactorParameters &parameters);
} // namespace PlateImpact
