#include "plate_impact/contact/line_law.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/lambert_w.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace PlateImpact
{
  namespace constants = boost::math::double_constants;

  LineLaw::LineLaw(const double radius,
                   const double half_length,
                   const double modulus,
                   const double constant)
    : constant(constant)
    , compliance(1. / (constants::pi * half_length * modulus))
    , force_scale(half_length * half_length * half_length * constants::pi *
                  modulus / (2. * radius))
    , least_logarithm(std::max(1., constant))
    , tangent_force(force_scale * std::exp(2. * (constant - least_logarithm)))
    , largest_indentation(compliance * tangent_force * least_logarithm)
  {}



  double
  LineLaw::logarithm(const double force) const
  {
    // a^2 / l^2 = F / force_scale
    return constant - 0.5 * std::log(force / force_scale);
  }



  double
  LineLaw::force(const double indentation) const
  {
    if (indentation <= 0.)
      return 0.;
    if (indentation >= largest_indentation)
      return tangent_force +
        (indentation - largest_indentation) * stiffness(indentation);

    // alpha = -C/2 g ln g, g = F / (force_scale e^{2 c}), C = compliance
    // force_scale e^{2 c}: ln g = W_{-1}(-2 alpha / C)
    const double scale = force_scale * std::exp(2. * constant);
    const double q     = 2. * indentation / (compliance * scale);
    if (q < std::numeric_limits<double>::min())
      return 0.;
    return -scale * q / boost::math::lambert_wm1(-q);
  }



  double
  LineLaw::stiffness(const double indentation) const
  {
    if (indentation <= 0.)
      return 0.;
    const double L = indentation >= largest_indentation ?
      least_logarithm :
      logarithm(
        std::max(force(indentation), std::numeric_limits<double>::min()));
    return 1. / (compliance * (L - 0.5));
  }



  double
  LineLaw::potential(const double indentation) const
  {
    if (indentation <= 0.)
      return 0.;
    const double F      = force(std::min(indentation, largest_indentation));
    const double beyond = std::max(0., indentation - largest_indentation);
    const double alpha  = std::min(indentation, largest_indentation);
    return 0.5 * F * alpha - 0.125 * compliance * F * F +
      beyond * (F + 0.5 * beyond * stiffness(largest_indentation));
  }
} // namespace PlateImpact
