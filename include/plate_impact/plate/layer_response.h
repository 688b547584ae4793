#pragma once

#include "plate_impact/base/parameters.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace PlateImpact
{
  struct PlateSection;

  /// What the struck face of an elastic layer does beyond plate theory and a
  /// half-space.
  ///
  /// Hertz's law holds the local compression of a half-space. The shear of
  /// plate theory goes on to waves far shorter than the thickness, which the
  /// half-space answers already, and plate theory lacks the bending by the
  /// thickness stress under a load on one face. A load patch that belongs to
  /// the plate and a compliance in series with Hertz's law cure both, from the
  /// static compliance C(k) of the struck face of a free layer at the
  /// wavenumber k (doc/theory.md).
  ///
  /// Lengths are relative to the thickness h.
  class LayerResponse
  {
  public:
    /// @param section  of which the isotropic layer counts that answers a
    ///                 contact as it does
    /// @param load     Hertz disc, uniform disc or strip
    LayerResponse(const PlateSection &section, LoadShape load);

    /// Radius of the patch, c/h, with which plate and layer answer alike to
    /// waves longer than the thickness; 0 where there is none.
    double
    patch_radius() const
    {
      // the terms k^-2 of plate and layer agree
      const double square = spread / 5. *
        (1. / (1.2 * shear_correction * (1. - poissons_ratio)) - 1.);
      return square > 0. ? std::sqrt(square) : 0.;
    }

    /// beta / h^2 of the functional w + beta div theta that load and reading
    /// use with another radius; 0 with patch_radius().
    double
    rotation_factor(const double radius) const
    {
      return 1. / (12. * shear_correction * (1. - poissons_ratio)) - 0.1 -
        radius * radius / (2. * spread);
    }

    /// Lambda of the compliance Lambda / (G h) in series with the law of a
    /// sphere, negative: layer less half-space less plate.
    double
    sphere_constant(const double radius) const
    {
      return integral(radius, /*is_line=*/false) /
        boost::math::double_constants::two_pi;
    }

    /// Lambda of the plate's side of a line contact, F' (1 - nu) / (pi G) (ln
    /// (h/a) + Lambda), with F' the force per length and a the half-width of
    /// the contact.
    double
    line_constant(const double radius) const
    {
      return boost::math::double_constants::ln_two + 0.5 +
        integral(radius, /*is_line=*/true) / (1. - poissons_ratio);
    }

  private:
    /// What C(k) has beyond half-space and plate theory, over all wavenumbers.
    double
    integral(double radius, bool is_line) const;

    const double    poissons_ratio;
    const double    shear_correction;
    const LoadShape load;

    /// The transform of the pressure has the square 1 - x^2 / spread + ...
    const double spread;
  };
} // namespace PlateImpact
