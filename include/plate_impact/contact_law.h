#ifndef plate_impact_contact_law_h
#define plate_impact_contact_law_h

#include <memory>

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
    /// Gonzalez (1996), doi:10.1007/BF02440162, in one dimension.
    /// Implementations evaluate it without cancellation when a is close to b.
    /// [N]
    virtual double
    mean_force(double a, double b) const = 0;

    /// Indentation at which the force is reached; 0 for forces up to 0. [m]
    virtual double
    indentation(double force) const = 0;
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

  private:
    const double k;
  };

  /// Coefficient of Hertz's law for a sphere and a half-space,
  /// k = 4/3 sqrt(r) / (compliance of the impactor + compliance of the target),
  /// both compliances [1/Pa], radius [m]. [N/m^{3/2}]
  double
  hertz_coefficient(double radius,
                    double impactor_compliance,
                    double target_compliance);

  /// The law that the scene names: `Sun` (eq. 17 as printed: 1/E for the plate,
  /// after Yang & Sun, NASA CR-165460, 1981) or `Hertz` ((1 - nu^2)/E for both
  /// bodies, Johnson, Contact Mechanics, eq. 4.23).
  std::unique_ptr<const ContactLaw>
  make_contact_law(const Parameters &parameters);
} // namespace PlateImpact

#endif
