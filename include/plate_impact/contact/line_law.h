#pragma once

#include "plate_impact/contact/contact_law.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/lambert_w.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace PlateImpact
{
  /// A cylinder of radius r on a half-space along the length 2l (eq. 32 of the
  /// paper, Johnson, Contact Mechanics, sec. 5.3):
  ///   alpha = F / (pi l E*) (c + ln(l/a)),  a = sqrt(4 (F/2l) r / (pi E*)).
  /// The paper prints a with F in place of the force per length, and inverts to
  /// a power 3/2 (eq. 33). The inverse is Lambert's function W_{-1}. It is for
  /// indentations up to the largest one: at 1/2 the bracket would turn back.
  class LineLaw : public ContactLaw
  {
  public:
    /// Johnson's.
    static constexpr double constant_of_half_space = 1.886;

    /// @param half_length  l [m]
    /// @param modulus      E* [Pa]
    /// @param constant     c
    LineLaw(const double radius,
            const double half_length,
            const double modulus,
            const double constant = constant_of_half_space)
      : compliance(1. / (pi * half_length * modulus))
      , force_scale(half_length * half_length * half_length * pi * modulus /
                    (2. * radius) * std::exp(2. * constant))
      , largest_indentation(compliance * force_scale * std::max(1., constant) *
                            std::exp(-2. * std::max(1., constant)))
    {}

    double
    force(const double indentation) const override
    {
      if (indentation <= 0.)
        return 0.;
      // alpha = -C/2 g ln g, g = F / force_scale, C = compliance force_scale:
      // ln g = W_{-1}(-2 alpha / C)
      const double q = 2. * indentation / (compliance * force_scale);
      if (q < std::numeric_limits<double>::min())
        return 0.;
      return -force_scale * q / boost::math::lambert_wm1(-q);
    }

    double
    stiffness(const double indentation) const override
    {
      if (indentation <= 0.)
        return 0.;
      const double logarithm = -0.5 *
        std::log(
          std::max(force(indentation), std::numeric_limits<double>::min()) /
          force_scale);
      return 1. / (compliance * (logarithm - 0.5));
    }

    double
    potential(const double indentation) const override
    {
      const double F = force(indentation);
      return 0.5 * F * indentation - 0.125 * compliance * F * F;
    }

  private:
    static constexpr double pi = boost::math::double_constants::pi;

    const double compliance;  ///< 1 / (pi l E*) [m/N]
    const double force_scale; ///< at which c + ln(l/a) = 0 [N]

  public:
    /// Where the contact is as wide as long, a = l, or the bracket is 1. [m]
    const double largest_indentation;
  };
} // namespace PlateImpact
