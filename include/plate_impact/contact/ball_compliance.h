#pragma once

namespace PlateImpact
{
  /// What an elastic ball, pressed at its pole and held by its own inertia,
  /// gives way beyond the half-space of Hertz's law, relative to its centre of
  /// mass; negative, for it gives way less. Quasi-static: the period of the
  /// ball's lowest mode is short against the contact.
  ///
  /// With w_n the radial displacement of the pole's surface per unit of the
  /// pressure P_n(cos theta), G w_n / R without dimension, from the regular
  /// spheroidal solutions of degree n without shear traction (Love, Treatise on
  /// the Mathematical Theory of Elasticity, ch. 11), and with the transform of
  /// Hertz's pressure, H(x) = 3 (sin x - x cos x) / x^3,
  ///   C = -1 / (2 pi G R) sum_n (1 - nu - (n + 1/2) G w_n / R)
  ///                             H((n + 1/2) a / R)^2,
  /// the sum over the sphere's degrees less the integral over the wave numbers
  /// n + 1/2 of the half-space, for which (n + 1/2) G w_n / R = 1 - nu. Up to
  /// terms of the order of (a / R)^2, which Hertz's law leaves out as well.
  ///
  /// @param radius          R [m]
  /// @param shear_modulus   G [Pa]
  /// @param contact_radius  a, below R [m]
  /// @return C [m/N]
  double
  ball_compliance(double radius,
                  double shear_modulus,
                  double poissons_ratio,
                  double contact_radius);
} // namespace PlateImpact
