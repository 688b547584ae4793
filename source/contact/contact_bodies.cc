#include "plate_impact/contact/contact_bodies.h"

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/yielding_law.h"
#include "plate_impact/plate/plate_section.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace PlateImpact
{
  namespace constants = boost::math::double_constants;

  double
  hertz_coefficient(const double radius,
                    const double impactor_compliance,
                    const double target_compliance)
  {
    return 4. / 3. * std::sqrt(radius) /
      (impactor_compliance + target_compliance);
  }



  ContactBodies::ContactBodies(const Parameters   &parameters,
                               const PlateSection &section)
    : radius_of_impactor(parameters.impactor.radius)
    , length(parameters.impactor.is_cylinder() ? parameters.impactor.length :
                                                 0.)
    , least_poissons_ratio(0.5)
  {
    const ImpactorParameters &impactor = parameters.impactor;
    modulus                            = 1. /
      ((1. - impactor.poissons_ratio * impactor.poissons_ratio) /
         impactor.youngs_modulus +
       section.half_space_compliance);

    double     least_pressure = std::numeric_limits<double>::infinity();
    const auto consider       = [&](const auto &body) {
      const double Y = body.yield_strength, nu = body.poissons_ratio;
      const double first_pressure = Y * yield_pressure_ratio(nu);
      if (Y == 0.)
        least_poissons_ratio = std::min(least_poissons_ratio, nu);
      if (Y == 0. || first_pressure >= least_pressure)
        return;
      least_pressure = first_pressure;
      weaker         = {Y, nu, modulus * (1. - nu * nu) / body.youngs_modulus};
    };
    if (!parameters.plate.is_laminate())
      consider(parameters.plate);
    consider(impactor);
    if (weaker && length == 0.)
      yield_indentation =
        PlateImpact::yield_indentation(radius_of_impactor,
                                       modulus,
                                       weaker->yield_strength,
                                       weaker->poissons_ratio);
  }



  double
  ContactBodies::radius(const double force, const double indentation) const
  {
    if (length > 0.)
      return std::sqrt(4. * force * radius_of_impactor /
                       (constants::pi * modulus * length));
    double squared = radius_of_impactor * std::max(0., indentation);
    if (yield_indentation && indentation > 1.9 * *yield_indentation)
      squared *=
        std::pow(indentation / (1.9 * *yield_indentation),
                 0.14 * std::exp(23. * weaker->yield_strength / modulus));
    return std::sqrt(squared);
  }



  double
  ContactBodies::mean_pressure(const double force,
                               const double indentation) const
  {
    const double a = radius(force, indentation);
    return force / (length > 0. ? 2. * a * length : constants::pi * a * a);
  }



  double
  ContactBodies::elastic_pressure(const double force,
                                  const double indentation) const
  {
    return (length > 0. ? 4. / constants::pi : 1.5) *
      mean_pressure(force, indentation);
  }



  double
  ContactBodies::pressure_over_strength(const double poissons_ratio) const
  {
    return length > 0. ? 1.67 : yield_pressure_ratio(poissons_ratio);
  }



  double
  ContactBodies::first_yield_pressure() const
  {
    return weaker->yield_strength *
      pressure_over_strength(weaker->poissons_ratio);
  }



  double
  ContactBodies::elastic_strength(const double pressure) const
  {
    return pressure / pressure_over_strength(least_poissons_ratio);
  }
} // namespace PlateImpact
