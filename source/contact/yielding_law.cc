#include "plate_impact/contact/yielding_law.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// c of the law.
    constexpr double softening_rate = 0.0823;
  } // namespace



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
                           const double yield_indentation)
    : hertz(coefficient)
    , first_yield(yield_indentation)
  {}



  double
  YieldingLaw::softening(const double indentation) const
  {
    return 1. + softening_rate * std::max(0., indentation / first_yield - 1.);
  }



  double
  YieldingLaw::force(const double indentation) const
  {
    return hertz.force(indentation) / std::cbrt(softening(indentation));
  }



  double
  YieldingLaw::stiffness(const double indentation) const
  {
    const double s       = softening(indentation);
    const double elastic = hertz.stiffness(indentation) / std::cbrt(s);
    return indentation <= first_yield ?
      elastic :
      elastic - force(indentation) * softening_rate / (3. * first_yield * s);
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



  double
  YieldingLaw::indentation(const double force) const
  {
    const double elastic = hertz.indentation(force);
    if (elastic <= first_yield)
      return elastic;
    // F grows faster than alpha
    std::uintmax_t n_iterations = 100;
    return boost::math::tools::newton_raphson_iterate(
      [this, force](const double alpha) {
        return std::make_pair(this->force(alpha) / force - 1.,
                              stiffness(alpha) / force);
      },
      elastic,
      elastic,
      first_yield * force / hertz.force(first_yield),
      std::numeric_limits<double>::digits / 2 + 2,
      n_iterations);
  }



  PlasticUnloading::PlasticUnloading(const double yield_indentation)
    : first_yield(yield_indentation)
  {}



  double
  PlasticUnloading::dent(const double largest_indentation) const
  {
    const double w = largest_indentation / first_yield;
    return w > 1. ? largest_indentation * (1. - std::pow(w, -0.28)) *
        (1. - std::pow(w, -0.69)) :
                    0.;
  }



  double
  PlasticUnloading::power(const double largest_indentation) const
  {
    const double w = largest_indentation / first_yield;
    return 1.5 * std::pow(std::max(1., w), -0.0331);
  }
} // namespace PlateImpact
