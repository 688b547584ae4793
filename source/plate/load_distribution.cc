#include "plate_impact/plate/load_distribution.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include "plate_impact/plate/plate_geometry.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Points along a length, so many on each of the cells there: on fewer, a
    /// load is a row of point loads under which nothing converges.
    unsigned int
    n_points(const double length,
             const double finest_cell,
             const double least,
             const double most)
    {
      return std::clamp(std::ceil(8. * length / finest_cell), least, most);
    }



    /// Distances from the centre or the axis of a load, with weights that sum
    /// to one.
    using Radial = std::vector<std::pair<double, double>>;


    /// Gauss points s in [0, 1].
    /// @param at  distance and density of the force at s
    template <typename Function>
    Radial
    gauss_points(const unsigned int n, const Function &at)
    {
      const QGauss<1> rule(n);
      Radial          points;
      for (unsigned int i = 0; i < n; ++i)
        {
          const auto [distance, density] = at(rule.point(i)[0]);
          points.emplace_back(distance, rule.weight(i) * density);
        }
      return points;
    }



    /// Quadrature of a load on a disc, with as many equidistant angles as
    /// radii: these integrate smooth functions with the mirror symmetries of
    /// the plate to high order.
    std::vector<LoadPoint>
    disc(const Radial &radii)
    {
      std::vector<LoadPoint> points;
      const std::size_t      n = radii.size();
      for (const auto &[r, weight] : radii)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double angle = (j + 0.5) / n * numbers::PI_2;
            points.push_back(
              {r * Point<2>(std::cos(angle), std::sin(angle)), weight / n});
          }
      return points;
    }



    /// Quadrature of a load along 0 <= x <= l, at distances y from the axis.
    std::vector<LoadPoint>
    strip(const double       half_length,
          const unsigned int n_intervals,
          const Radial      &across)
    {
      // QIterated refuses the round-off in weights of very many intervals
      const QGauss<1>        rule(2);
      const double           interval = half_length / n_intervals;
      std::vector<LoadPoint> points;
      for (unsigned int i = 0; i < n_intervals; ++i)
        for (unsigned int q = 0; q < rule.size(); ++q)
          for (const auto &[y, weight] : across)
            points.push_back({Point<2>((i + rule.point(q)[0]) * interval, y),
                              rule.weight(q) / n_intervals * weight});
      return points;
    }
  } // namespace



  std::vector<LoadPoint>
  make_load_distribution(const ContactParameters &contact,
                         const double             length,
                         const double             finest_cell)
  {
    const double       c = contact.patch_radius;
    const unsigned int n_along =
      n_points(0.5 * length, finest_cell, 400, 4e5) / 2;
    // Shape functions have kinks at cell sides: many points, not a high order
    const unsigned int n_on_disc = n_points(c, finest_cell, 40, 400);
    switch (contact.load_distribution)
      {
        case LoadShape::point:
          return {{Point<2>(), 1.}};
        case LoadShape::Hertz_disc:
          // s = sqrt(1 - (r/c)^2): p r dr is 3 s^2 ds
          return disc(gauss_points(n_on_disc, [c](const double s) {
            return std::pair(c * std::sqrt(1. - s * s), 3. * s * s);
          }));
        case LoadShape::uniform_disc:
          // s = (r/c)^2: p r dr is ds
          return disc(gauss_points(n_on_disc, [c](const double s) {
            return std::pair(c * std::sqrt(s), 1.);
          }));
        case LoadShape::line:
          return strip(0.5 * length, n_along, {{0., 1.}});
        case LoadShape::strip:
          // y = c sin(phi), phi = pi s / 2: p dy is 2 cos^2(phi) ds
          return strip(0.5 * length,
                       n_along,
                       gauss_points(n_points(c, finest_cell, 24, 400),
                                    [c](const double s) {
                                      const double phi = numbers::PI_2 * s;
                                      return std::pair(c * std::sin(phi),
                                                       2. * std::cos(phi) *
                                                         std::cos(phi));
                                    }));
      }
    throw std::logic_error("no such load distribution");
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



  template <>
  const std::vector<Word<LoadShape>> Choices<LoadShape>::words = {
    {LoadShape::point, "point"},
    {LoadShape::Hertz_disc, "Hertz disc"},
    {LoadShape::uniform_disc, "uniform disc"},
    {LoadShape::line, "line"},
    {LoadShape::strip, "strip"}};
} // namespace PlateImpact
