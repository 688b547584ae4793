#include "plate_impact/contact/contact_law.h"

#include "plate_impact/base/parameters.h"
#include "plate_impact/plate/plate_section.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/lambert_w.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace PlateImpact
{
  namespace constants = boost::math::double_constants;

  double
  ContactLaw::mean_force(const double a, const double b) const
  {
    const double low = std::min(a, b), high = std::max(a, b);
    if (high <= 0. || low == high)
      return force(high);
    const double way = approach(high) - approach(low);
    if (low <= 0.)
      return potential(high) / way;
    if (high - low > 0.05 * high)
      return (potential(high) - potential(low)) / way;

    // Close indentations, where the quotient cancels: Gauss quadrature is exact
    // to round-off for a law that is smooth on the scale of the indentation.
    using Gauss     = boost::math::quadrature::gauss<double, 10>;
    const auto rate = [this](const double alpha) {
      return approach_rate(alpha);
    };
    const auto work = [this](const double alpha) {
      return force(alpha) * approach_rate(alpha);
    };
    return Gauss::integrate(work, low, high) /
      Gauss::integrate(rate, low, high);
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



  SeriesLaw::SeriesLaw(const double coefficient, const double compliance)
    : hertz(coefficient)
    , compliance(compliance)
  {
    if (compliance >= 0.)
      return;
    // C F' = -0.9 with F' = 3/2 k alpha^{1/2}
    const double root   = -0.6 / (coefficient * compliance);
    largest_indentation = root * root;
  }



  double
  SeriesLaw::force(const double indentation) const
  {
    const double beyond = indentation - largest_indentation;
    return beyond <= 0. ? hertz.force(indentation) :
                          largest_force() + beyond * stiffness(indentation);
  }



  double
  SeriesLaw::stiffness(const double indentation) const
  {
    return hertz.stiffness(std::min(indentation, largest_indentation));
  }



  double
  SeriesLaw::potential(const double indentation) const
  {
    const double F      = force(indentation);
    const double beyond = std::max(0., indentation - largest_indentation);
    return hertz.potential(std::min(indentation, largest_indentation)) +
      0.5 * compliance * F * F +
      (beyond > 0. ? 0.5 * beyond * (largest_force() + F) : 0.);
  }



  double
  SeriesLaw::mean_force(const double a, const double b) const
  {
    const double low = std::min(a, b), high = std::max(a, b);
    if (low <= 0. || high >= largest_indentation)
      return ContactLaw::mean_force(a, b);

    // change of the energies over that of the approach, both divided by the
    // change of alpha, so that nothing cancels: q = (F_b - F_a) / (alpha_b -
    // alpha_a) of x^3 and x^2, alpha = x^2
    const double x = std::sqrt(low), y = std::sqrt(high);
    const double q   = hertz.force(1.) * (low + x * y + high) / (x + y);
    const double sum = hertz.force(low) + hertz.force(high);
    return (hertz.mean_force(low, high) + 0.5 * compliance * sum * q) /
      (1. + compliance * q);
  }



  double
  SeriesLaw::indentation(const double force) const
  {
    const double beyond = force - largest_force();
    return beyond <= 0. ?
      hertz.indentation(force) :
      largest_indentation + beyond / stiffness(largest_indentation);
  }



  double
  SeriesLaw::approach(const double indentation) const
  {
    return indentation + compliance * force(indentation);
  }



  double
  SeriesLaw::approach_rate(const double indentation) const
  {
    return 1. + compliance * stiffness(indentation);
  }



  double
  SeriesLaw::indentation_under(const double approach) const
  {
    if (approach <= 0. || compliance == 0.)
      return approach;
    if (compliance < 0.)
      {
        const double beyond = approach - this->approach(largest_indentation);
        if (beyond >= 0.)
          return largest_indentation +
            beyond / approach_rate(largest_indentation);
      }

    // s^2 + C k s^3 = approach, s^2 = alpha, from the first terms of the root
    // in powers of q; as Newton's method doubles the digits, half of them are
    // enough for the last step
    const double Ck     = compliance * hertz.force(1.);
    const double simple = std::sqrt(approach), q = -Ck * simple;
    const double bound = compliance < 0. ? std::sqrt(largest_indentation) : 0.;
    std::uintmax_t n_iterations = 50;
    const double   s            = boost::math::tools::newton_raphson_iterate(
      [Ck, approach](const double s) {
        return std::make_pair(s * s * (1. + Ck * s) - approach,
                              s * (2. + 3. * Ck * s));
      },
      std::clamp(simple * (1. + q * (0.5 + q * (0.625 + q))),
                 std::min(simple, bound),
                 std::max(simple, bound)),
      std::min(simple, bound),
      std::max(simple, bound),
      std::numeric_limits<double>::digits / 2 + 2,
      n_iterations);
    return s * s;
  }



  double
  SeriesLaw::largest_force() const
  {
    return hertz.force(largest_indentation);
  }



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



  double
  LineLaw::indentation(const double force) const
  {
    if (force <= 0.)
      return 0.;
    if (force >= tangent_force)
      return largest_indentation +
        (force - tangent_force) / stiffness(largest_indentation);
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
    return std::sqrt(4. * force_per_length * radius /
                     (constants::pi * modulus));
  }



  double
  contact_modulus(const Parameters &parameters)
  {
    const double nu = parameters.impactor.poissons_ratio;
    return 1. /
      ((1. - nu * nu) / parameters.impactor.youngs_modulus +
       PlateSection(parameters.plate).half_space_compliance);
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



  double
  contact_pressure(const Parameters &parameters,
                   const double      force,
                   const double      indentation)
  {
    const double a = contact_radius(parameters, force, indentation);
    return parameters.impactor.is_cylinder() ?
      2. * force / (constants::pi * a * parameters.impactor.length) :
      1.5 * force / (constants::pi * a * a);
  }
} // namespace PlateImpact
