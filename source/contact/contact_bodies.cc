#include "plate_impact/contact/contact_bodies.h"

#include "plate_impact/base/parameters.h"
#include "plate_impact/plate/plate_section.h"

#include <limits>

namespace PlateImpact
{
  ContactBodies::ContactBodies(const Parameters   &parameters,
                               const PlateSection &section)
    : radius_of_impactor(parameters.impactor.radius)
    , length(2. * parameters.impactor.contact_half_length())
  {
    const ImpactorParameters &impactor = parameters.impactor;
    impactor_compliance =
      (1. - impactor.poissons_ratio * impactor.poissons_ratio) /
      impactor.youngs_modulus;
    modulus = 1. / (impactor_compliance + section.half_space_compliance);

    // C of a material, and what the strength is multiplied by under the contact
    const auto yield_pressure_ratio = [](const double nu) {
      return 1.295 * std::exp(0.736 * nu);
    };
    const auto yield_ratio = [&](const double nu) {
      return length > 0. ? 1.67 : yield_pressure_ratio(nu);
    };
    double least_pressure       = std::numeric_limits<double>::infinity(),
           least_poissons_ratio = 0.5;
    const auto consider         = [&](const auto &body) {
      const double Y = body.yield_strength, nu = body.poissons_ratio;
      const double first_pressure = Y * yield_pressure_ratio(nu);
      if (Y == 0.)
        least_poissons_ratio = std::min(least_poissons_ratio, nu);
      if (Y == 0. || first_pressure >= least_pressure)
        return;
      least_pressure = first_pressure;
      weaker         = {Y,
                        Y * yield_ratio(nu),
                        modulus * (1. - nu * nu) / body.youngs_modulus};
    };
    if (!parameters.plate.is_laminate())
      consider(parameters.plate);
    consider(impactor);
    pressure_over_strength = yield_ratio(least_poissons_ratio);
    if (weaker && length == 0.)
      yield_indentation = radius_of_impactor *
        std::pow(pi * weaker->first_yield_pressure / (2. * modulus), 2);
  }



  double
  ball_compliance(const ImpactorParameters &ball, const double contact_radius)
  {
    const double ratio = contact_radius / ball.radius, nu = ball.poissons_ratio,
                 shear_modulus = 0.5 * ball.youngs_modulus / (1. + nu);
    // G w_n / R. With u = A grad(r^n P_n) + B (r^2 grad(r^n P_n) + alpha x r^n
    // P_n), and for n = 1 the second alone, with the alpha that balances the
    // uniform force of inertia.
    const auto displacement_of_degree = [nu](const unsigned int n) {
      const double lambda = 2. * nu / (1. - 2. * nu); // over G
      if (n == 0)
        return 1. / (3. * lambda + 2.);
      if (n == 1)
        return 1.2 / (6. * lambda + 4.);
      const double alpha =
        -2. * (n * lambda + 3. * n + 1.) / ((n + 3.) * lambda + n + 5.);
      // no shear traction with B = 1
      const double A        = -(2. * n + alpha) / (2. * n - 2.);
      const double pressure = 2. * A * n * (n - 1.) +
        lambda * (2. * n + alpha * (n + 3.)) + 2. * (n + alpha) * (n + 1.);
      return (A * n + n + alpha) / pressure;
    };
    double sum = 0.;
    // terms fall as 1 / n up to R / a and as n^-5 beyond
    for (unsigned int n = 0; n * ratio < 20.; ++n)
      {
        const double x         = (n + 0.5) * ratio;
        const double transform = x > 0.01 ?
          3. * (std::sin(x) - x * std::cos(x)) / (x * x * x) :
          1. - 0.1 * x * x;
        sum += (1. - nu - (n + 0.5) * displacement_of_degree(n)) * transform *
          transform;
      }
    return -sum /
      (boost::math::double_constants::two_pi * shear_modulus * ball.radius);
  }
} // namespace PlateImpact
