#ifndef plate_impact_contact_unloading_h
#define plate_impact_contact_unloading_h

#include <cmath>

namespace PlateImpact
{
  /// How a contact unloads that leaves a dent. From the largest indentation so
  /// far alpha_m, where the force was F_m,
  ///   F = F_m ((alpha - alpha_0) / (alpha_m - alpha_0))^n,
  /// with the dent alpha_0 and the power n.
  class Unloading
  {
  public:
    virtual ~Unloading() = default;

    /// alpha_0; 0 as long as the contact is elastic. [m]
    virtual double
    dent(double largest_indentation) const = 0;

    /// n.
    virtual double
    power(double largest_indentation) const = 0;

    /// n when the bodies touch again after they have parted.
    virtual double
    reloading_power(const double largest_indentation) const
    {
      return power(largest_indentation);
    }
  };


  /// That curve, or the one of reloading, from the dent to an end where it has
  /// a length. Within it the functions are those of ContactLaw.
  struct UnloadingCurve
  {
    double dent = 0., end = 0., end_force = 0., power = 1.;

    double
    force(const double indentation) const
    {
      return end_force * std::pow(share(indentation), power);
    }

    double
    stiffness(const double indentation) const
    {
      return power / (end - dent) * end_force *
        std::pow(share(indentation), power - 1.);
    }

    /// @param low,high  in this order
    double
    mean_force(const double low, const double high) const
    {
      return end_force / (power + 1.) *
        difference_quotient(low, high, power + 1.);
    }

    double
    mean_stiffness(const double low, const double high) const
    {
      return end_force / (end - dent) * difference_quotient(low, high, power);
    }

  private:
    double
    share(const double indentation) const
    {
      return (indentation - dent) / (end - dent);
    }

    /// (y^p - x^p) / (y - x) of the shares x and y, without cancellation.
    double
    difference_quotient(const double low,
                        const double high,
                        const double p) const
    {
      const double x = share(low), d = (high - low) / (end - dent);
      return x > 0. ? std::pow(x, p) * std::expm1(p * std::log1p(d / x)) / d :
                      std::pow(d, p - 1.);
    }
  };
} // namespace PlateImpact

#endif
