#ifndef plate_impact_contact_yielding_law_h
#define plate_impact_contact_yielding_law_h

#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/contact/unloading.h"

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
  ///   F = k alpha^{3/2} (1 + c (w - 1))^{-1/3}.
  /// The form has Hertz's law at w = 1 and a force that grows a little more
  /// than in proportion at large w. Its one constant c is fitted to
  /// quasi-static indentations by CalculiX (tests/calculix).
  class YieldingLaw : public ContactLaw
  {
  public:
    /// @param coefficient        k of Hertz's law [N/m^{3/2}]
    /// @param yield_indentation  alpha_y [m]
    YieldingLaw(double coefficient, double yield_indentation);

    double
    force(double indentation) const override;
    double
    stiffness(double indentation) const override;
    double
    potential(double indentation) const override;
    double
    indentation(double force) const override;

  private:
    /// 1 + c (w - 1).
    double
    softening(double indentation) const;

    const HertzLaw hertz;
    const double   first_yield; ///< alpha_y [m]
  };


  /// Unloading of such a contact, with w_m = alpha_m / alpha_y above 1 (Etsion,
  /// Kligerman & Kadin 2005, doi:10.1016/j.ijsolstr.2004.12.006):
  ///   alpha_0 = alpha_m (1 - w_m^-0.28) (1 - w_m^-0.69),
  ///   n = 1.5 w_m^-0.0331.
  class PlasticUnloading : public Unloading
  {
  public:
    /// @param yield_indentation alpha_y [m]
    explicit PlasticUnloading(double yield_indentation);

    double
    dent(double largest_indentation) const override;
    double
    power(double largest_indentation) const override;

  private:
    const double first_yield;
  };
} // namespace PlateImpact

#endif
