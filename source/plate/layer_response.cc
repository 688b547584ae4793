#include "plate_impact/plate/layer_response.h"

#include "plate_impact/plate/plate_section.h"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <map>
#include <tuple>

namespace PlateImpact
{
  namespace
  {
    /// 2 sinh^2(y/2) / (sinh y + y) + 2 cosh^2(y/2) / (sinh y - y): the
    /// symmetric and the antisymmetric deformation of a layer.
    double
    compliance_of_layer(const double y)
    {
      const double E         = std::exp(-y);
      const double symmetric = (1. - E) * (1. - E) / (1. - E * E + 2. * y * E);
      if (y > 1.)
        return symmetric + (1. + E) * (1. + E) / (1. - E * E - 2. * y * E);

      // sinh y - y without cancellation
      double term = y * y * y / 6., difference = 0.;
      for (unsigned int n = 4; difference + term > difference; n += 2)
        {
          difference += term;
          term *= y * y / (n * (n + 1));
        }
      return symmetric + (std::cosh(y) + 1.) / difference;
    }
  } // namespace



  LayerResponse::LayerResponse(const PlateSection &section,
                               const LoadShape     load)
    : poissons_ratio(section.poissons_ratio)
    , shear_correction(section.shear_correction_factor)
    , load(load)
    , spread(load == LoadShape::Hertz_disc ? 5. : 4.)
  {}



  double
  LayerResponse::integral(const double radius, const bool is_line) const
  {
    // computed once: that takes as long as an impact of a sweep, whose
    // impactors strike one plate
    using Key = std::tuple<double, double, double, LoadShape, bool>;
    static thread_local std::map<Key, double> known;
    const Key key{poissons_ratio, shear_correction, radius, load, is_line};
    if (const auto place = known.find(key); place != known.end())
      return place->second;

    // G/h [C(k) - (1-nu)/(G k) - C_R(k)] y at y = k h, C_R the compliance of
    // plate theory under the patch, whose pressure has the transform P: of
    // Hankel, of a hemispherical one on a disc, 3 (sin x - x cos x) / x^3, and
    // a constant one, 2 J_1(x) / x; of Fourier, of a hemispherical one on a
    // strip, the same
    const double nu     = poissons_ratio;
    const double beta   = rotation_factor(radius);
    const auto   excess = [&](const double y) {
      const double x       = radius * y;
      const double P       = load == LoadShape::Hertz_disc ?
                3. * boost::math::sph_bessel(1, x) / x :
                2. * ::j1(x) / x;
      const double bending = 1. - beta * y * y;
      const double result  = 0.5 * (1. - nu) * (compliance_of_layer(y) - 2.) -
        P * P *
          (6. * (1. - nu) * bending * bending / (y * y * y) +
           1. / (shear_correction * y));
      return is_line ? (result + (1. - nu) * std::exp(-y)) / y : result;
    };
    // The layer decays within y of 40, the plate over some oscillations of the
    // transform. Gauss points do not come close to 0, where terms cancel.
    using Gauss              = boost::math::quadrature::gauss<double, 20>;
    const double oscillation = boost::math::double_constants::pi / radius;
    double       sum = 0., begin = 0.;
    while (begin < std::max(40., 64. * oscillation))
      {
        const double end =
          begin + (begin < 40. ? std::min(2., oscillation) : oscillation);
        sum += Gauss::integrate(excess, begin, end);
        begin = end;
      }
    return known[key] = sum;
  }
} // namespace PlateImpact
