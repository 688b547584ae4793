#ifndef plate_impact_contact_contact_law_h
#define plate_impact_contact_contact_law_h

#include <memory>
#include <optional>

namespace PlateImpact
{
  struct Parameters;

  /// Force between impactor and plate as a function of the indentation, the
  /// approach of the impactor's centre to the plate's midsurface beyond first
  /// touch. The force is zero for negative indentation and never decreases.
  class ContactLaw
  {
  public:
    virtual ~ContactLaw() = default;

    /// Force at an indentation [m]. [N]
    virtual double
    force(double indentation) const = 0;

    /// Derivative of the force with respect to the indentation. [N/m]
    virtual double
    stiffness(double indentation) const = 0;

    /// Work stored by the contact: integral of the force from 0. [J]
    virtual double
    potential(double indentation) const = 0;

    /// Mean of the force over the interval between two indentations,
    /// (U(b) - U(a)) / (b - a) with U the potential: the discrete gradient of
    /// Gonzalez (1996), doi:10.1007/BF02440162, in one dimension. Does not
    /// cancel when a is close to b. [N]
    virtual double
    mean_force(double a, double b) const;

    /// Indentation at which the force is reached; 0 for forces up to 0. [m]
    virtual double
    indentation(double force) const = 0;

    /// k of a law F = k alpha^{3/2}; empty for others. [N/m^{3/2}]
    virtual std::optional<double>
    hertz_coefficient() const
    {
      return {};
    }
  };

  /// Hertz's law of two elastic bodies touching at a point, F = k alpha^{3/2}
  /// (eq. 16 of Mahajan & Dutta).
  class HertzLaw : public ContactLaw
  {
  public:
    /// @param coefficient k [N/m^{3/2}]
    explicit HertzLaw(double coefficient);

    double
    force(double indentation) const override;
    double
    stiffness(double indentation) const override;
    double
    potential(double indentation) const override;
    double
    mean_force(double a, double b) const override;
    double
    indentation(double force) const override;
    std::optional<double>
    hertz_coefficient() const override
    {
      return k;
    }

  private:
    const double k;
  };

  /// A cylinder of radius r that touches a half-space along the length 2l (eq.
  /// 32 of the paper, Johnson, Contact Mechanics, sec. 5.3):
  ///   alpha = F / (pi l E*) (1.886 + ln(l/a)),  a = sqrt(4 (F/2l) r / (pi
  ///   E*)).
  /// The paper prints a with the total force F in place of the force per
  /// length, and inverts to a power 3/2 (eq. 33); up to the logarithm the law
  /// is linear.
  ///
  /// The inverse is Lambert's function W_{-1}. The law loses its meaning when
  /// the contact is as wide as long, a = l, and would turn back at a = 4 l:
  /// from a = l on it is continued by its tangent.
  class LineLaw : public ContactLaw
  {
  public:
    /// @param half_length  l [m]
    /// @param modulus      E* [Pa]
    LineLaw(double radius, double half_length, double modulus);

    double
    force(double indentation) const override;
    double
    stiffness(double indentation) const override;
    double
    potential(double indentation) const override;
    double
    indentation(double force) const override;

  private:
    /// 1.886 + ln(l/a) at a force.
    double
    logarithm(double force) const;

    const double compliance;          ///< 1 / (pi l E*) [m/N]
    const double force_scale;         ///< force at which a = l [N]
    const double largest_indentation; ///< where the tangent begins [m]
  };

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

  /// The law that the scene names: `line` (eq. 32), `Sun` (eq. 17 as printed:
  /// 1/E for the plate, after Yang & Sun, NASA CR-165460, 1981) or `Hertz` ((1
  /// - nu^2)/E for both bodies, Johnson, Contact Mechanics, eq. 4.23).
  std::unique_ptr<const ContactLaw>
  make_contact_law(const Parameters &parameters);
} // namespace PlateImpact

#endif
