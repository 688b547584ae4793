#pragma once

#include "plate_impact/contact/contact_law.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  /// Coefficient of Hertz's law for a sphere and a half-space,
  /// k = 4/3 sqrt(r) / (compliance of the impactor + compliance of the target),
  /// both compliances [1/Pa], radius [m]. [N/m^{3/2}]
  inline double
  hertz_coefficient(const double radius,
                    const double impactor_compliance,
                    const double target_compliance)
  {
    return 4. / 3. * std::sqrt(radius) /
      (impactor_compliance + target_compliance);
  }


  /// Hertz's law of two elastic bodies touching at a point, F = k alpha^{3/2}
  /// (eq. 16 of Mahajan & Dutta).
  class HertzLaw : public ContactLaw
  {
  public:
    /// @param coefficient k [N/m^{3/2}]
    explicit HertzLaw(const double coefficient)
      : k(coefficient)
    {}

    double
    force(const double indentation) const override
    {
      return indentation > 0. ? k * indentation * std::sqrt(indentation) : 0.;
    }

    double
    stiffness(const double indentation) const override
    {
      return indentation > 0. ? 1.5 * k * std::sqrt(indentation) : 0.;
    }

    double
    potential(const double indentation) const override
    {
      return 0.4 * indentation * force(indentation);
    }

    // without quadrature: a sweep takes a fifth less time
    double
    mean_force(const double a, const double b) const override
    {
      if (std::min(a, b) <= 0.)
        return ContactLaw::mean_force(a, b);
      // (x^5 - y^5) / (x^2 - y^2) with x^2 = a, y^2 = b, divided by x - y so
      // that nothing cancels
      const double x = std::sqrt(a), y = std::sqrt(b);
      return 0.4 * k * (a * a + b * b + x * y * (a + x * y + b)) / (x + y);
    }

    double
    mean_stiffness(const double a, const double b) const override
    {
      if (std::min(a, b) <= 0.)
        return ContactLaw::mean_stiffness(a, b);
      const double x = std::sqrt(a), y = std::sqrt(b);
      return k * (a + x * y + b) / (x + y);
    }

    std::optional<double>
    hertz_coefficient() const override
    {
      return k;
    }

  private:
    const double k;
  };
} // namespace PlateImpact
