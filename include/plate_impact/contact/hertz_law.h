#pragma once

#include "plate_impact/contact/contact_law.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

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

    const double k; ///< [N/m^{3/2}]
  };


  /// First loading of an elastic, perfectly plastic contact of a sphere:
  /// Hertz's law up to alpha_y; beyond it, with w = alpha / alpha_y,
  ///   F = k alpha^{3/2} (1 + c (w - 1))^{-1/3},  c = 0.066 + 0.033 q,
  /// where q is the share of the body that yields in 1/E*. Fitted to
  /// quasi-static indentations of finite elements (tests/calculix), which it
  /// follows within 2.5 % up to w = 100.
  class YieldingLaw : public ContactLaw
  {
  public:
    /// @param coefficient          k of Hertz's law [N/m^{3/2}]
    /// @param yield_indentation    alpha_y [m]
    /// @param share_of_compliance  q
    YieldingLaw(const double coefficient,
                const double yield_indentation,
                const double share_of_compliance)
      : hertz(coefficient)
      , first_yield(yield_indentation)
      , rate(0.066 + 0.033 * share_of_compliance)
    {}

    double
    force(const double indentation) const override
    {
      return hertz.force(indentation) * share_of_hertz(indentation);
    }

    double
    stiffness(const double indentation) const override
    {
      const double s       = softening(indentation);
      const double elastic = hertz.stiffness(indentation) / std::cbrt(s);
      return indentation <= first_yield ?
        elastic :
        elastic - force(indentation) * rate / (3. * first_yield * s);
    }

    double
    potential(const double indentation) const override
    {
      double work = hertz.potential(std::min(indentation, first_yield));
      // octave by octave, in which Gauss quadrature is exact to round-off
      for (double begin = first_yield; begin < indentation; begin *= 2.)
        work += boost::math::quadrature::gauss<double, 15>::integrate(
          [this](const double alpha) { return force(alpha); },
          begin,
          std::min(2. * begin, indentation));
      return work;
    }

    /// The force over that of Hertz's law.
    double
    share_of_hertz(const double indentation) const
    {
      return 1. / std::cbrt(softening(indentation));
    }

  private:
    /// 1 + c (w - 1).
    double
    softening(const double indentation) const
    {
      return 1. + rate * std::max(0., indentation / first_yield - 1.);
    }

    const HertzLaw hertz;
    const double   first_yield; ///< alpha_y [m]
    const double   rate;        ///< c
  };


  /// Unloading of such a contact. With x = 1 - F_m / (k alpha_m^{3/2}) the
  /// energy given back and the dent are
  ///   W / (F_m alpha_m) = 0.4 (1 - x)^{2.2 - 1.25 x},
  ///   alpha_0 / alpha_m = x / (0.345 + 0.77 x),
  /// and n = (1 - alpha_0 / alpha_m) / (W / (F_m alpha_m)) - 1. Fitted to the
  /// same indentations, within 2 % in energy and 0.01 alpha_m in the dent.
  /// Etsion, Kligerman & Kadin (2005), doi:10.1016/j.ijsolstr.2004.12.006, give
  /// back up to 6 % less energy there.
  inline std::shared_ptr<const Unloading>
  plastic_unloading(const std::shared_ptr<const YieldingLaw> &law)
  {
    const auto dent = [law](const double largest) {
      const double x = 1. - law->share_of_hertz(largest);
      return largest * x / (0.345 + 0.77 * x);
    };
    const auto power = [law, dent](const double largest) {
      const double x    = 1. - law->share_of_hertz(largest);
      const double back = 0.4 * std::pow(1. - x, 2.2 - 1.25 * x);
      return (1. - dent(largest) / largest) / back - 1.;
    };
    return std::make_shared<Unloading>(Unloading{dent, power, power});
  }
} // namespace PlateImpact
