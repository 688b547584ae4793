#include "plate_impact/contact/yielding_law.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  double
  yield_pressure_ratio(const double poissons_ratio)
  {
    return 1.295 * std::exp(0.736 * poissons_ratio);
  }



  double
  yield_indentation(const double radius,
                    const double modulus,
                    const double yield_strength,
                    const double poissons_ratio)
  {
    const double pi     = boost::math::double_constants::pi;
    const double strain = pi * yield_pressure_ratio(poissons_ratio) *
      yield_strength / (2. * modulus);
    return radius * strain * strain;
  }



  YieldingLaw::YieldingLaw(const double coefficient,
                           const double yield_indentation,
                           const double share_of_compliance)
    : hertz(coefficient)
    , first_yield(yield_indentation)
    , rate(0.066 + 0.033 * share_of_compliance)
  {}



  double
  YieldingLaw::softening(const double indentation) const
  {
    return 1. + rate * std::max(0., indentation / first_yield - 1.);
  }



  double
  YieldingLaw::share_of_hertz(const double indentation) const
  {
    return 1. / std::cbrt(softening(indentation));
  }



  double
  YieldingLaw::force(const double indentation) const
  {
    return hertz.force(indentation) * share_of_hertz(indentation);
  }



  double
  YieldingLaw::stiffness(const double indentation) const
  {
    const double s       = softening(indentation);
    const double elastic = hertz.stiffness(indentation) / std::cbrt(s);
    return indentation <= first_yield ?
      elastic :
      elastic - force(indentation) * rate / (3. * first_yield * s);
  }



  double
  YieldingLaw::potential(const double indentation) const
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



  std::shared_ptr<const Unloading>
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
