#ifndef plate_impact_contact_contact_area_h
#define plate_impact_contact_contact_area_h

#include <optional>

namespace PlateImpact
{
  struct Parameters;

  /// Coefficient of Hertz's law for a sphere and a half-space,
  /// k = 4/3 sqrt(r) / (compliance of the impactor + compliance of the target),
  /// both compliances [1/Pa], radius [m]. [N/m^{3/2}]
  double
  hertz_coefficient(double radius,
                    double impactor_compliance,
                    double target_compliance);

  /// Half-width [m] of the contact of a cylinder under a force per length
  /// [N/m], sqrt(4 p r / (pi E*)).
  double
  line_contact_half_width(double radius,
                          double force_per_length,
                          double modulus);

  /// E*, 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2. [Pa]
  double
  contact_modulus(const Parameters &parameters);

  /// A body in contact that may yield.
  struct YieldingBody
  {
    double yield_strength; ///< Y [Pa]
    double poissons_ratio;
    double share_of_compliance; ///< E* (1 - nu^2) / E
  };

  /// The body that yields first; empty where the scene gives no yield strength.
  std::optional<YieldingBody>
  weaker_body(const Parameters &parameters);

  /// Indentation from which on the contact of a sphere yields; empty for
  /// cylinders and where no yield strength is given. [m]
  std::optional<double>
  yield_indentation(const Parameters &parameters);

  /// Radius of Hertz's contact of a sphere, sqrt(r alpha) (Johnson, Contact
  /// Mechanics, eqs. 4.22 and 4.23), 0 for negative indentations; half-width of
  /// that of a cylinder. Of one that yields, from w = alpha / alpha_y = 1.9 on,
  /// sqrt(r alpha (w / 1.9)^B), B = 0.14 exp(23 Y / E*) (Jackson & Green 2005,
  /// doi:10.1115/1.1866166). [m]
  /// @param force        [N]
  /// @param indentation  under that force [m]
  double
  contact_radius(const Parameters &parameters,
                 double            force,
                 double            indentation);

  /// Largest pressure of Hertz's contact, of a sphere or a cylinder that stays
  /// elastic. [Pa]
  /// @param force        [N]
  /// @param indentation  under that force, above 0 [m]
  double
  contact_pressure(const Parameters &parameters,
                   double            force,
                   double            indentation);
} // namespace PlateImpact

#endif
