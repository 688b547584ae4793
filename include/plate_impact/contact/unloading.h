#ifndef plate_impact_contact_unloading_h
#define plate_impact_contact_unloading_h

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
} // namespace PlateImpact

#endif
