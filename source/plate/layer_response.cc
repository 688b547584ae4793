#include "plate_impact/plate/layer_response.h"

#include "plate_impact/plate/plate_section.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <tuple>

namespace PlateImpact
{
  namespace
  {
    namespace constants = boost::math::double_constants;

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



    /// Transforms of the pressure on a patch of radius or half-width 1,
    /// normalized, at x > 0: of Hankel, of a hemispherical one on a disc, 3
    /// (sin x - x cos x) / x^3, and a constant one, 2 J_1(x) / x; of Fourier,
    /// of a hemispherical one on a strip, the same.
    double
    transform_of_pressure(const LoadShape load, const double x)
    {
      return load == LoadShape::Hertz_disc ?
        3. * boost::math::sph_bessel(1, x) / x :
        2. * ::j1(x) / x;
    }



    /// The integral of a function of y like LayerResponse::excess() over all
    /// wavenumbers.
    template <typename Function>
    double
    integral(const Function &function, const double radius)
    {
      // The layer decays within y of 40, the plate over some oscillations of
      // the transform. Gauss points do not come close to 0, where terms cancel.
      using Gauss                 = boost::math::quadrature::gauss<double, 20>;
      const double oscillation    = constants::pi / radius;
      const double n_oscillations = 64.;
      double       sum = 0., begin = 0.;
      while (begin < std::max(40., n_oscillations * oscillation))
        {
          const double end =
            begin + (begin < 40. ? std::min(2., oscillation) : oscillation);
          sum += Gauss::integrate(function, begin, end);
          begin = end;
        }
      return sum;
    }



    /// Poisson's ratio, shear correction, radius, load, and which constant.
    using LayerKey = std::tuple<double, double, double, LoadShape, std::string>;

    /// A constant of a layer, computed once: that takes as long as an impact of
    /// a sweep, whose impactors strike one plate.
    double
    remembered(const LayerKey &layer, const std::function<double()> &compute)
    {
      static thread_local std::map<LayerKey, double> known;
      const auto                                     place = known.find(layer);
      return place != known.end() ? place->second : known[layer] = compute();
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
  LayerResponse::patch_radius() const
  {
    // the terms k^-2 of plate and layer agree
    const double square = spread / 5. *
      (1. / (1.2 * shear_correction * (1. - poissons_ratio)) - 1.);
    return square > 0. ? std::sqrt(square) : 0.;
  }



  double
  LayerResponse::excess(const double y, const double radius) const
  {
    const double P       = transform_of_pressure(load, radius * y);
    const double bending = 1. - rotation_factor(radius) * y * y;
    return 0.5 * (1. - poissons_ratio) * (compliance_of_layer(y) - 2.) -
      P * P *
      (6. * (1. - poissons_ratio) * bending * bending / (y * y * y) +
       1. / (shear_correction * y));
  }



  double
  LayerResponse::sphere_constant(const double radius) const
  {
    return remembered(
      {poissons_ratio, shear_correction, radius, load, "sphere"},
      [&] {
        return integral([&](const double y) { return excess(y, radius); },
                        radius) /
          (2. * constants::pi);
      });
  }



  double
  LayerResponse::line_constant(const double radius) const
  {
    return remembered(
      {poissons_ratio, shear_correction, radius, load, "line"},
      [&] {
        const auto excess_of_line = [&](const double y) {
          return (excess(y, radius) + (1. - poissons_ratio) * std::exp(-y)) / y;
        };
        return constants::ln_two + 0.5 +
          integral(excess_of_line, radius) / (1. - poissons_ratio);
      });
  }



  double
  load_rotation_factor(const PlateParameters   &plate,
                       const ContactParameters &contact)
  {
    if (contact.local_response != LocalResponse::layer)
      return 0.;
    const double h = plate.thickness;
    const double beta =
      LayerResponse(PlateSection(plate), contact.load_distribution)
        .rotation_factor(contact.patch_radius / h);
    return std::abs(beta) > 1e-9 ? beta * h * h : 0.;
  }
} // namespace PlateImpact
