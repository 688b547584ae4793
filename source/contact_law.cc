#include "plate_impact/contact_law.h"

#include "plate_impact/parameters.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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



  double
  hertz_coefficient(const double radius,
                    const double impactor_compliance,
                    const double target_compliance)
  {
    return 4. / 3. * std::sqrt(radius) /
      (impactor_compliance + target_compliance);
  }



  std::unique_ptr<const ContactLaw>
  make_contact_law(const Parameters &parameters)
  {
    const PlateParameters    &plate    = parameters.plate;
    const ImpactorParameters &impactor = parameters.impactor;
    const double              impactor_compliance =
      (1. - impactor.poissons_ratio * impactor.poissons_ratio) /
      impactor.youngs_modulus;

    if (parameters.contact.law == "Sun")
      return std::make_unique<HertzLaw>(
        hertz_coefficient(impactor.radius,
                          impactor_compliance,
                          1. / plate.youngs_modulus));
    if (parameters.contact.law == "Hertz")
      return std::make_unique<HertzLaw>(
        hertz_coefficient(impactor.radius,
                          impactor_compliance,
                          (1. - plate.poissons_ratio * plate.poissons_ratio) /
                            plate.youngs_modulus));
    throw std::logic_error("no contact law named " + parameters.contact.law);
  }
} // namespace PlateImpact
