#include "plate_impact/contact/ball_compliance.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// G w_n / R. With u = A grad(r^n P_n) + B (r^2 grad(r^n P_n) + alpha x r^n
    /// P_n), and for n = 1 the second alone, with the alpha that balances the
    /// uniform force of inertia.
    double
    displacement_of_degree(const unsigned int n, const double nu)
    {
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
    }
  } // namespace



  double
  ball_compliance(const double radius,
                  const double shear_modulus,
                  const double poissons_ratio,
                  const double contact_radius)
  {
    const double ratio = contact_radius / radius, nu = poissons_ratio;
    double       sum = 0.;
    // terms fall as 1 / n up to R / a and as n^-5 beyond
    for (unsigned int n = 0; n * ratio < 20.; ++n)
      {
        const double x         = (n + 0.5) * ratio;
        const double transform = x > 0.01 ?
          3. * (std::sin(x) - x * std::cos(x)) / (x * x * x) :
          1. - 0.1 * x * x;
        sum += (1. - nu - (n + 0.5) * displacement_of_degree(n, nu)) *
          transform * transform;
      }
    return -sum /
      (boost::math::double_constants::two_pi * shear_modulus * radius);
  }
} // namespace PlateImpact
