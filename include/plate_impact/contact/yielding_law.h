#pragma once

#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/contact/unloading.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace PlateImpact
{
  /// C: a material yields from the largest contact pressure C Y on.
  inline double
  yield_pressure_ratio(const double poissons_ratio)
  {
    return 1.295 * std::exp(0.736 * poissons_ratio);
  }

  /// Indentation at which a sphere or the flat body under it yields first,
  ///   alpha_y = r (pi C Y / (2 E*))^2,  C = 1.295 exp(0.736 nu)
  /// (Green 2005, doi:10.1016/j.ijmecsci.2005.03.001; Jackson & Green 2005,
  /// doi:10.1115/1.1866166). [m]
  /// @param radius          r [m]
  /// @param modulus         E* [Pa]
  /// @param yield_strength  Y of the body that yields [Pa]
  /// @param poissons_ratio  nu of that body
  inline double
  yield_indentation(const double radius,
                    const double modulus,
                    const double yield_strength,
                    const double poissons_ratio)
  {
    const double strain = boost::math::double_constants::pi *
      yield_pressure_ratio(poissons_ratio) * yield_strength / (2. * modulus);
    return radius * strain * strain;
  }


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
