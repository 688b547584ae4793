#pragma once

#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/contact/unloading.h"

#include <memory>

namespace PlateImpact
{
  /// Indentation at which a sphere or the flat body under it yields first,
  ///   alpha_y = r (pi C Y / (2 E*))^2,  C = 1.295 exp(0.736 nu)
  /// (Green 2005, doi:10.1016/j.ijmecsci.2005.03.001; Jackson & Green 2005,
  /// doi:10.1115/1.1866166), with the yield strength and Poisson's ratio of the
  /// body that yields. [m]
  /// @param radius          r [m]
  /// @param modulus         E* [Pa]
  /// @param yield_strength  Y [Pa]
  double
  yield_indentation(double radius,
                    double modulus,
                    double yield_strength,
                    double poissons_ratio);

  /// C: a material yields below the surface from the largest contact pressure C
  /// Y on.
  double
  yield_pressure_ratio(double poissons_ratio);


  /// First loading of an elastic, perfectly plastic contact of a sphere:
  /// Hertz's law up to alpha_y; beyond it, with w = alpha / alpha_y,
  ///   F = k alpha^{3/2} (1 + c (w - 1))^{-1/3},  c = 0.066 + 0.033 q,
  /// where q is the share of the body that yields in 1/E*: 1 under a rigid
  /// ball, 1/2 between equal bodies. The form has Hertz's law at w = 1 and a
  /// force that grows a little more than in proportion at large w. Its two
  /// constants are fitted to quasi-static indentations of finite elements
  /// (tests/calculix), which it follows within 2.5 % up to w = 100.
  class YieldingLaw : public ContactLaw
  {
  public:
    /// @param coefficient          k of Hertz's law [N/m^{3/2}]
    /// @param yield_indentation    alpha_y [m]
    /// @param share_of_compliance  q
    YieldingLaw(double coefficient,
                double yield_indentation,
                double share_of_compliance);

    double
    force(double indentation) const override;
    double
    stiffness(double indentation) const override;
    double
    potential(double indentation) const override;

    /// The force over that of Hertz's law.
    double
    share_of_hertz(double indentation) const;

  private:
    /// 1 + c (w - 1).
    double
    softening(double indentation) const;

    const HertzLaw hertz;
    const double   first_yield; ///< alpha_y [m]
    const double   rate;        ///< c
  };


  /// Unloading of such a contact. With x = 1 - F_m / (k alpha_m^{3/2}) the
  /// energy given back and the dent are
  ///   W / (F_m alpha_m) = 0.4 (1 - x)^{2.2 - 1.25 x},
  ///   alpha_0 / alpha_m = x / (0.345 + 0.77 x),
  /// and n = (1 - alpha_0 / alpha_m) / (W / (F_m alpha_m)) - 1: Hertz's at x =
  /// 0. Fitted to the same indentations, which it follows within 2 % in energy
  /// and 0.01 alpha_m in the dent. Etsion, Kligerman & Kadin (2005),
  /// doi:10.1016/j.ijsolstr.2004.12.006, give back up to 6 % less energy there.
  std::shared_ptr<const Unloading>
  plastic_unloading(const std::shared_ptr<const YieldingLaw> &law);
} // namespace PlateImpact
