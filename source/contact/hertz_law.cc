#include "plate_impact/contact/hertz_law.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  HertzLaw::HertzLaw(const double coefficient)
    : k(coefficient)
  {}



  double
  HertzLaw::force(const double indentation) const
  {
    return indentation > 0. ? k * indentation * std::sqrt(indentation) : 0.;
  }



  double
  HertzLaw::stiffness(const double indentation) const
  {
    return indentation > 0. ? 1.5 * k * std::sqrt(indentation) : 0.;
  }



  double
  HertzLaw::potential(const double indentation) const
  {
    return 0.4 * indentation * force(indentation);
  }



  double
  HertzLaw::indentation(const double force) const
  {
    return force > 0. ? std::cbrt(force / k * (force / k)) : 0.;
  }



  double
  HertzLaw::mean_force(const double a, const double b) const
  {
    if (std::min(a, b) <= 0.)
      return ContactLaw::mean_force(a, b);
    // (x^5 - y^5) / (x^2 - y^2) with x^2 = a, y^2 = b, divided by x - y so that
    // nothing cancels
    const double x = std::sqrt(a), y = std::sqrt(b);
    return 0.4 * k * (a * a + b * b + x * y * (a + x * y + b)) / (x + y);
  }



  double
  HertzLaw::mean_stiffness(const double a, const double b) const
  {
    if (std::min(a, b) <= 0.)
      return ContactLaw::mean_stiffness(a, b);
    const double x = std::sqrt(a), y = std::sqrt(b);
    return k * (a + x * y + b) / (x + y);
  }
} // namespace PlateImpact
