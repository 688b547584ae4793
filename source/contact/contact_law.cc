#include "plate_impact/contact/contact_law.h"

#include "plate_impact/base/parameters.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/lambert_w.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace PlateImpact
{
  namespace numbers = boost::math::double_constants;

  namespace
  {
    /// Johnson's constant of the line contact.
    constexpr double line_constant = 1.886;
  } // namespace



  double
  ContactLaw::mean_force(const double a, const double b) const
  {
    const double low = std::min(a, b), high = std::max(a, b);
    if (high <= 0. || low == high)
      return force(high);
    if (low <= 0.)
      return potential(high) / (high - low);
    if (high - low > 0.05 * high)
      return (potential(high) - potential(low)) / (high - low);

    // Close indentations, where the quotient cancels: Gauss quadrature is exact
    // to round-off for a law that is smooth on the scale of the indentation.
    return boost::math::quadrature::gauss<double, 10>::integrate(
             [this](const double alpha) { return force(alpha); },
             low,
             high) /
      (high - low);
  }



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
  HertzLaw::mean_force(const double a, const double b) const
  {
    const double low = std::min(a, b), high = std::max(a, b);
    if (high <= 0.)
      return 0.;
    if (low <= 0.)
      return potential(high) / (high - low);

    // (x^5 - y^5) / (x^2 - y^2) with x^2 = a, y^2 = b, divided by x - y so that
    // nothing cancels
    const double x = std::sqrt(a), y = std::sqrt(b);
    return 0.4 * k * (a * a + b * b + x * y * (a + x * y + b)) / (x + y);
  }



  double
  HertzLaw::indentation(const double force) const
  {
    return force > 0. ? std::cbrt(force / k * (force / k)) : 0.;
  }



  LineLaw::LineLaw(const double radius,
                   const double half_length,
                   const double modulus)
    : compliance(1. / (numbers::pi * half_length * modulus))
    , force_scale(half_length * half_length * half_length * numbers::pi *
                  modulus / (2. * radius))
    , largest_indentation(compliance * force_scale * line_constant)
  {}



  double
  LineLaw::logarithm(const double force) const
  {
    // a^2 / l^2 = F / force_scale
    return line_constant - 0.5 * std::log(force / force_scale);
  }



  double
  LineLaw::force(const double indentation) const
  {
    if (indentation <= 0.)
      return 0.;
    if (indentation >= largest_indentation)
      return force_scale +
        (indentation - largest_indentation) * stiffness(indentation);

    // alpha = -C/2 g ln g, g = F / (force_scale e^{2 c}), C = compliance
    // force_scale e^{2 c}: ln g = W_{-1}(-2 alpha / C)
    const double scale = force_scale * std::exp(2. * line_constant);
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
      line_constant :
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



  double
  LineLaw::indentation(const double force) const
  {
    if (force <= 0.)
      return 0.;
    if (force >= force_scale)
      return largest_indentation +
        (force - force_scale) / stiffness(largest_indentation);
    return compliance * force * logarithm(force);
  }



  double
  hertz_coefficient(const double radius,
                    const double impactor_compliance,
                    const double target_compliance)
  {
    return 4. / 3. * std::sqrt(radius) /
      (impactor_compliance + target_compliance);
  }



  double
  line_contact_half_width(const double radius,
                          const double force_per_length,
                          const double modulus)
  {
    return std::sqrt(4. * force_per_length * radius / (numbers::pi * modulus));
  }



  double
  contact_modulus(const Parameters &parameters)
  {
    const double nu_i = parameters.impactor.poissons_ratio,
                 nu_p = parameters.plate.poissons_ratio;
    return 1. /
      ((1. - nu_i * nu_i) / parameters.impactor.youngs_modulus +
       (1. - nu_p * nu_p) / parameters.plate.youngs_modulus);
  }



  double
  contact_radius(const Parameters &parameters,
                 const double      force,
                 const double      indentation)
  {
    const ImpactorParameters &impactor = parameters.impactor;
    return impactor.is_cylinder() ?
      line_contact_half_width(impactor.radius,
                              force / impactor.length,
                              contact_modulus(parameters)) :
      std::sqrt(impactor.radius * std::max(0., indentation));
  }



  std::unique_ptr<const ContactLaw>
  make_contact_law(const Parameters &parameters)
  {
    const PlateParameters    &plate    = parameters.plate;
    const ImpactorParameters &impactor = parameters.impactor;
    const double              impactor_compliance =
      (1. - impactor.poissons_ratio * impactor.poissons_ratio) /
      impactor.youngs_modulus;

    switch (parameters.contact.law)
      {
        case ForceLaw::line:
          return std::make_unique<LineLaw>(impactor.radius,
                                           0.5 * impactor.length,
                                           contact_modulus(parameters));
        case ForceLaw::Sun:
          return std::make_unique<HertzLaw>(
            hertz_coefficient(impactor.radius,
                              impactor_compliance,
                              1. / plate.youngs_modulus));
        case ForceLaw::Hertz:
          return std::make_unique<HertzLaw>(hertz_coefficient(
            impactor.radius,
            impactor_compliance,
            (1. - plate.poissons_ratio * plate.poissons_ratio) /
              plate.youngs_modulus));
      }
    throw std::logic_error("no such contact law");
  }
} // namespace PlateImpact
