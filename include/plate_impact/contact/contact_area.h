#ifndef plate_impact_contact_contact_area_h
#define plate_impact_contact_contact_area_h

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

  /// Radius of Hertz's contact of a sphere, sqrt(r alpha) (Johnson, Contact
  /// Mechanics, eqs. 4.22 and 4.23), 0 for negative indentations; half-width of
  /// that of a cylinder. [m]
  /// @param force        [N]
  /// @param indentation  under that force [m]
  double
  contact_radius(const Parameters &parameters,
                 double            force,
                 double            indentation);

  /// Largest pressure of Hertz's contact, of a sphere or a cylinder. [Pa]
  /// @param force        [N]
  /// @param indentation  under that force, above 0 [m]
  double
  contact_pressure(const Parameters &parameters,
                   double            force,
                   double            indentation);
} // namespace PlateImpact

#endif
