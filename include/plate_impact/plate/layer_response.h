#pragma once

#include "plate_impact/base/parameters.h"

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
    patch_radius() const;

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
    sphere_constant(double radius) const;

    /// Lambda of the plate's side of a line contact, F' (1 - nu) / (pi G) (ln
    /// (h/a) + Lambda), with F' the force per length and a the half-width of
    /// the contact.
    double
    line_constant(double radius) const;

  private:
    /// G/h [C(k) - (1-nu)/(G k) - C_R(k)] y at y = k h, C_R the compliance of
    /// plate theory under the patch.
    double
    excess(double y, double radius) const;

    const double    poissons_ratio;
    const double    shear_correction;
    const LoadShape load;

    /// The transform of the pressure has the square 1 - x^2 / spread + ...
    const double spread;
  };

  /// beta of the functional w + beta div theta that load and reading of a scene
  /// use, 0 for w alone: a half-space, or the layer's own patch radius. [m^2]
  double
  load_rotation_factor(const PlateParameters   &plate,
                       const ContactParameters &contact);
} // namespace PlateImpact
