#ifndef plate_impact_contact_contact_law_h
#define plate_impact_contact_contact_law_h

#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace PlateImpact
{
  struct Parameters;

  /// Force between impactor and plate as a function of the indentation of the
  /// bodies at the contact, zero for negative ones, never decreasing.
  ///
  /// The approach of the impactor's centre to the plate's midsurface beyond
  /// first touch is the indentation, but for laws in series with a compliance,
  /// whose approach has another part. It grows with the indentation. Energies
  /// are those of the approach.
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

    /// Work stored by the contact: integral of the force over the approach. [J]
    virtual double
    potential(double indentation) const = 0;

    /// Mean of the force over the approach between two indentations, (U(b) -
    /// U(a)) / (delta(b) - delta(a)) with U the potential and delta the
    /// approach: the discrete gradient of Gonzalez (1996),
    /// doi:10.1007/BF02440162, in one dimension. Does not cancel when a is
    /// close to b. [N]
    virtual double
    mean_force(double a, double b) const;

    /// Indentation at which the force is reached; 0 for forces up to 0. [m]
    virtual double
    indentation(double force) const = 0;

    /// Approach at an indentation. [m]
    virtual double
    approach(const double indentation) const
    {
      return indentation;
    }

    /// Derivative of the approach with respect to the indentation, above 0. [-]
    virtual double
    approach_rate(double /*indentation*/) const
    {
      return 1.;
    }

    /// Indentation under an approach. [m]
    virtual double
    indentation_under(const double approach) const
    {
      return approach;
    }

    /// What the contact gives back from an indentation on; differs from the
    /// potential for laws that dissipate. [J]
    virtual double
    stored_energy(const double indentation) const
    {
      return potential(indentation);
    }

    /// What it has dissipated when it reaches an indentation. [J]
    virtual double
    dissipated_energy(double /*indentation*/) const
    {
      return 0.;
    }

    /// Up to which indentation the bodies no longer touch. [m]
    virtual double
    permanent_indentation() const
    {
      return 0.;
    }

    /// The law after a step that ended at an indentation; empty where it stays
    /// what it is, as for all laws without memory.
    virtual std::unique_ptr<const ContactLaw>
    after(double /*indentation*/) const
    {
      return nullptr;
    }

    /// The force up to which the law holds; beyond it is continued, so that
    /// iterations may pass there. [N]
    virtual double
    largest_force() const
    {
      return std::numeric_limits<double>::infinity();
    }

    /// k of a law F = k alpha^{3/2}; empty for others. [N/m^{3/2}]
    virtual std::optional<double>
    hertz_coefficient() const
    {
      return {};
    }
  };

  /// A law that is followed from step to step.
  class FollowedLaw
  {
  public:
    /// @param law  at first touch; must outlive this
    explicit FollowedLaw(const ContactLaw &law)
      : current(&law)
    {}

    const ContactLaw &
    operator*() const
    {
      return *current;
    }

    const ContactLaw *
    operator->() const
    {
      return current;
    }

    /// A step has ended.
    void
    follow(const double indentation)
    {
      if (auto next = current->after(indentation))
        {
          own     = std::move(next);
          current = own.get();
        }
    }

  private:
    const ContactLaw                 *current;
    std::unique_ptr<const ContactLaw> own;
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

  /// Hertz's law in series with a compliance C: the approach is alpha + C F,
  /// F = k alpha^{3/2}. C is negative where the plate under the contact is
  /// stiffer than plate theory and half-space together (LayerResponse). The
  /// approach then has a largest value, where C F' = -1; from C F' = -0.9 on,
  /// where the contact is about as wide as the plate is thick, the force is
  /// continued by its tangent.
  class SeriesLaw : public ContactLaw
  {
  public:
    /// @param coefficient k [N/m^{3/2}]
    /// @param compliance  C [m/N]
    SeriesLaw(double coefficient, double compliance);

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
    double
    approach(double indentation) const override;
    double
    approach_rate(double indentation) const override;
    double
    indentation_under(double approach) const override;
    double
    largest_force() const override;

  private:
    const HertzLaw hertz;
    const double   compliance;
    /// Where the tangent begins. [m]
    double largest_indentation = std::numeric_limits<double>::infinity();
  };

  /// A cylinder of radius r that touches a half-space along the length 2l (eq.
  /// 32 of the paper, Johnson, Contact Mechanics, sec. 5.3):
  ///   alpha = F / (pi l E*) (1.886 + ln(l/a)),  a = sqrt(4 (F/2l) r / (pi
  ///   E*)),
  /// or another constant in place of 1.886.
  /// The paper prints a with the total force F in place of the force per
  /// length, and inverts to a power 3/2 (eq. 33); up to the logarithm the law
  /// is linear.
  ///
  /// The inverse is Lambert's function W_{-1}. The law loses its meaning when
  /// the contact is as wide as long, a = l, and would turn back where the
  /// logarithm with its constant is 1/2: from a = l on, or from 1, it is
  /// continued by its tangent.
  class LineLaw : public ContactLaw
  {
  public:
    /// @param half_length  l [m]
    /// @param modulus      E* [Pa]
    /// @param constant     beside ln(l/a); Johnson's 1.886 is for half-spaces
    LineLaw(double radius,
            double half_length,
            double modulus,
            double constant = 1.886);

    double
    force(double indentation) const override;
    double
    stiffness(double indentation) const override;
    double
    potential(double indentation) const override;
    double
    indentation(double force) const override;

  private:
    /// constant + ln(l/a) at a force.
    double
    logarithm(double force) const;

    const double constant;
    const double compliance;          ///< 1 / (pi l E*) [m/N]
    const double force_scale;         ///< force at which a = l [N]
    const double least_logarithm;     ///< where the tangent begins
    const double tangent_force;       ///< there [N]
    const double largest_indentation; ///< there [m]
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

  /// Largest pressure of Hertz's contact, of a sphere or a cylinder. [Pa]
  /// @param force        [N]
  /// @param indentation  under that force, above 0 [m]
  double
  contact_pressure(const Parameters &parameters,
                   double            force,
                   double            indentation);
} // namespace PlateImpact

#endif
