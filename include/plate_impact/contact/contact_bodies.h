#pragma once

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace PlateImpact
{
  struct ImpactorParameters;
  struct Parameters;
  struct PlateSection;

  /// A body in contact that may yield.
  struct YieldingBody
  {
    double yield_strength; ///< Y [Pa]
    /// Of the contact from which on it yields, C Y (ContactBodies), under a
    /// cylinder 1.67 Y (Johnson, sec. 6.1). [Pa]
    double first_yield_pressure;
    double share_of_compliance; ///< E* (1 - nu^2) / E
  };


  /// Impactor and plate where they touch: how wide the contact is, what
  /// pressure it is under, and what yields.
  class ContactBodies
  {
  public:
    ContactBodies(const Parameters &parameters, const PlateSection &section);

    /// (1 - nu_1^2) / E_1. [1/Pa]
    double impactor_compliance;

    /// E*, 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2. [Pa]
    double modulus;

    /// The body that yields first; empty where the scene gives no yield
    /// strength.
    std::optional<YieldingBody> weaker;

    /// Indentation alpha_y from which on the contact of a sphere yields,
    ///   alpha_y = r (pi C Y / (2 E*))^2,  C = 1.295 exp(0.736 nu),
    /// with Y and nu of the body that yields (Green 2005,
    /// doi:10.1016/j.ijmecsci.2005.03.001; Jackson & Green 2005,
    /// doi:10.1115/1.1866166); empty for cylinders and where no yield strength
    /// is given. [m]
    std::optional<double> yield_indentation;

    /// Radius of a sphere's contact, sqrt(r alpha) (Johnson, Contact Mechanics,
    /// eqs. 4.22 and 4.23), of one that yields from w = alpha / alpha_y = 1.9
    /// on sqrt(r alpha (w / 1.9)^B), B = 0.14 exp(23 Y / E*) (Jackson & Green
    /// 2005); half-width of a cylinder's, sqrt(4 F r / (pi E* l)). [m]
    /// @param force        [N]
    /// @param indentation  under that force [m]
    double
    radius(const double force, const double indentation) const
    {
      if (length > 0.)
        return std::sqrt(4. * force * radius_of_impactor /
                         (pi * modulus * length));
      double squared = radius_of_impactor * std::max(0., indentation);
      if (yield_indentation && indentation > 1.9 * *yield_indentation)
        squared *=
          std::pow(indentation / (1.9 * *yield_indentation),
                   0.14 * std::exp(23. * weaker->yield_strength / modulus));
      return std::sqrt(squared);
    }

    /// Force over the area of the contact. [Pa]
    /// @param force        [N]
    /// @param indentation  under that force, above 0 [m]
    double
    mean_pressure(const double force, const double indentation) const
    {
      const double a = radius(force, indentation);
      return force / (length > 0. ? 2. * a * length : pi * a * a);
    }

    /// Largest pressure of an elastic contact, of a sphere 3/2 and of a
    /// cylinder 4/pi of the mean. [Pa]
    double
    elastic_pressure(const double force, const double indentation) const
    {
      return (length > 0. ? 4. / pi : 1.5) * mean_pressure(force, indentation);
    }

    /// First yield pressure over the strength, of the bodies whose strength is
    /// not given.
    double pressure_over_strength;

  private:
    static constexpr double pi = boost::math::double_constants::pi;

    double radius_of_impactor;
    double length; ///< of a cylinder; 0: a sphere [m]
  };


  /// What an elastic ball, pressed at its pole and held by its own inertia,
  /// gives way beyond the half-space of Hertz's law, relative to its centre of
  /// mass; negative, for it gives way less. Quasi-static: the period of the
  /// ball's lowest mode is short against the contact.
  ///   C = -1 / (2 pi G R) sum_n (1 - nu - (n + 1/2) G w_n / R)
  ///                             H((n + 1/2) a / R)^2,
  /// with w_n the radial displacement of the surface per unit of the pressure
  /// P_n(cos theta) by the spheroidal solutions of degree n (Love, Mathematical
  /// Theory of Elasticity, ch. 11), (n + 1/2) G w_n / R = 1 - nu that of the
  /// half-space, and H(x) = 3 (sin x - x cos x) / x^3 the transform of Hertz's
  /// pressure. Up to terms of the order of (a / R)^2, as Hertz's law.
  /// @param ball            with the radius R [m] and the shear modulus G [Pa]
  /// @param contact_radius  a, below R [m]
  /// @return C [m/N]
  double
  ball_compliance(const ImpactorParameters &ball, double contact_radius);
} // namespace PlateImpact
