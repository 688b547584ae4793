#ifndef plate_impact_contact_hertz_law_h
#define plate_impact_contact_hertz_law_h

#include "plate_impact/contact/contact_law.h"

namespace PlateImpact
{
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
    indentation(double force) const override;
    double
    mean_force(double a, double b) const override;
    double
    mean_stiffness(double a, double b) const override;
    std::optional<double>
    hertz_coefficient() const override
    {
      return k;
    }

  private:
    const double k;
  };
} // namespace PlateImpact

#endif
