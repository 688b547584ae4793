#include "plate_impact/contact/contact_area.h"

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



  std::optional<YieldingBody>
  weaker_body(const Parameters &parameters)
  {
    const double modulus = contact_modulus(parameters);
    const auto   body    = [modulus](const auto &of) {
      const double nu = of.poissons_ratio;
      return YieldingBody{of.yield_strength,
                          nu,
                          modulus * (1. - nu * nu) / of.youngs_modulus};
    };
    const auto first_pressure = [](const YieldingBody &of) {
      return of.yield_strength > 0. ?
        of.yield_strength * yield_pressure_ratio(of.poissons_ratio) :
        std::numeric_limits<double>::infinity();
    };
    const YieldingBody plate    = body(parameters.plate),
                       impactor = body(parameters.impactor);
    const YieldingBody &weaker =
      first_pressure(plate) <= first_pressure(impactor) ? plate : impactor;
    if (weaker.yield_strength > 0.)
      return weaker;
    return {};
  }



  std::optional<double>
  yield_indentation(const Parameters &parameters)
  {
    const std::optional<YieldingBody> weaker = weaker_body(parameters);
    if (!weaker || parameters.impactor.is_cylinder())
      return {};
    return yield_indentation(parameters.impactor.radius,
                             contact_modulus(parameters),
                             weaker->yield_strength,
                             weaker->poissons_ratio);
  }



  double
  contact_radius(const Parameters &parameters,
                 const double      force,
                 const double      indentation)
  {
    const ImpactorParameters &impactor = parameters.impactor;
    const double              modulus  = contact_modulus(parameters);
    if (impactor.is_cylinder())
      return line_contact_half_width(impactor.radius,
                                     force / impactor.length,
                                     modulus);
    double squared = impactor.radius * std::max(0., indentation);
    if (const auto first_yield = yield_indentation(parameters);
        first_yield && indentation > 1.9 * *first_yield)
      {
        const double Y = weaker_body(parameters)->yield_strength;
        squared *= std::pow(indentation / (1.9 * *first_yield),
                            0.14 * std::exp(23. * Y / modulus));
      }
    return std::sqrt(squared);
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
