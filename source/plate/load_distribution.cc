#include "plate_impact/plate/load_distribution.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include "plate_impact/plate/plate_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Where a load acts across, by s in [0, 1]: distance from its centre or
    /// axis, in patch radii, and density of the force.
    std::pair<double, double>
    across(const LoadShape load, const double s)
    {
      switch (load)
        {
          case LoadShape::Hertz_disc:
            // s = sqrt(1 - (r/c)^2): p r dr is 3 s^2 ds
            return {std::sqrt(1. - s * s), 3. * s * s};
          case LoadShape::uniform_disc:
            // s = (r/c)^2: p r dr is ds
            return {std::sqrt(s), 1.};
          case LoadShape::strip:
            // y = c sin(phi), phi = pi s / 2: p dy is 2 cos^2(phi) ds
            return {std::sin(numbers::PI_2 * s),
                    2. * std::pow(std::cos(numbers::PI_2 * s), 2)};
          default:
            return {0., 1.};
        }
    }
  } // namespace



  std::vector<LoadPoint>
  make_load_distribution(const ContactParameters &contact,
                         const double             length,
                         const double             finest_cell)
  {
    if (contact.load_is_singular())
      return {{Point<2>(), 1.}};
    // So many points on each of the cells there: on fewer, a load is a row of
    // point loads under which nothing converges. Shape functions have kinks at
    // cell sides: many points, not a high order.
    const auto n_points = [&](const double size,
                              const double least,
                              const double most) -> unsigned int {
      return std::clamp(std::ceil(8. * size / finest_cell), least, most);
    };
    const bool      is_disc = !contact.load_has_length();
    const double    c       = contact.patch_radius;
    const QGauss<1> radial(
      contact.load_is_line() ? 1 : n_points(c, is_disc ? 40 : 24, 400));
    // QIterated refuses the round-off in weights of very many intervals; as
    // many equidistant angles as radii integrate smooth functions with the
    // mirror symmetries of the plate to high order
    const QGauss<1>    along(is_disc ? 1 : 2);
    const unsigned int n_intervals =
      is_disc ? radial.size() : n_points(0.5 * length, 400, 4e5) / 2;
    std::vector<LoadPoint> points;
    for (unsigned int k = 0; k < radial.size(); ++k)
      {
        const auto [distance, density] =
          across(contact.load_distribution, radial.point(k)[0]);
        for (unsigned int i = 0; i < n_intervals; ++i)
          for (unsigned int j = 0; j < along.size(); ++j)
            {
              const double t     = (i + along.point(j)[0]) / n_intervals,
                           angle = numbers::PI_2 * t;
              points.push_back(
                {is_disc ?
                   c * distance * Point<2>(std::cos(angle), std::sin(angle)) :
                   Point<2>(0.5 * length * t, c * distance),
                 radial.weight(k) * density * along.weight(j) / n_intervals});
            }
      }
    return points;
  }



  std::vector<LoadPoint>
  on_meshed_part(std::vector<LoadPoint> points, const PlateParameters &plate)
  {
    const auto is_symmetric = geometry_of(plate).is_symmetric;
    for (unsigned int d = 0; d < 2; ++d)
      if (!is_symmetric[d])
        for (std::size_t p = 0, n = points.size(); p < n; ++p)
          if (points[p].point[d] != 0.)
            {
              points[p].weight *= 0.5;
              points.push_back(points[p]);
              points.back().point[d] *= -1.;
            }
    return points;
  }
} // namespace PlateImpact
