#include "plate_impact/contact/contact_area.h"

#include "plate_impact/base/parameters.h"
#include "plate_impact/plate/plate_section.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

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
