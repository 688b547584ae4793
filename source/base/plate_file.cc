#include "plate_impact/base/plate_file.h"

#include "plate_impact/base/exceptions.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace PlateImpact
{
  namespace
  {
    double
    distance_to(const std::array<PlanePoint, 2> &chord, const PlanePoint &p)
    {
      const auto &[a, b] = chord;
      const double x = b[0] - a[0], y = b[1] - a[1];
      const double along =
        ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y);
      const double nearest = std::clamp(along, 0., 1.);
      return std::hypot(a[0] + nearest * x - p[0], a[1] + nearest * y - p[1]);
    }
  } // namespace



  double
  PlateFile::distance_to_edge(const PlanePoint &point) const
  {
    double nearest   = std::numeric_limits<double>::max();
    bool   is_inside = false;
    for (const auto &chord : outline)
      {
        const auto &[a, b] = chord;
        nearest            = std::min(nearest, distance_to(chord, point));
        // a ray along x leaves the plate an odd number of times
        if ((a[1] > point[1]) != (b[1] > point[1]) &&
            point[0] < a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
          is_inside = !is_inside;
      }
    return is_inside ? nearest : -nearest;
  }



  double
  PlateFile::distance_to_edge(const PlanePoint  &point,
                              const unsigned int axis) const
  {
    const unsigned int across  = 1 - axis;
    double             nearest = std::numeric_limits<double>::max();
    for (const auto &[a, b] : outline)
      if ((a[across] > point[across]) != (b[across] > point[across]))
        nearest =
          std::min(nearest,
                   std::abs(a[axis] +
                            (point[across] - a[across]) /
                              (b[across] - a[across]) * (b[axis] - a[axis]) -
                            point[axis]));
    return distance_to_edge(point) < 0. ? -nearest : nearest;
  }



  double
  distance(const PlanePoint &a, const PlanePoint &b)
  {
    return std::hypot(b[0] - a[0], b[1] - a[1]);
  }



  VertexPair
  sorted(const unsigned int a, const unsigned int b)
  {
    return {{std::min(a, b), std::max(a, b)}};
  }



  std::array<PlanePoint, 2>
  box_around(const std::vector<PlanePoint> &points)
  {
    std::array<PlanePoint, 2> box = {{points.front(), points.front()}};
    for (const PlanePoint &point : points)
      for (const unsigned int d : {0, 1})
        {
          box[0][d] = std::min(box[0][d], point[d]);
          box[1][d] = std::max(box[1][d], point[d]);
        }
    return box;
  }



  std::string
  place(const PlanePoint &point)
  {
    return fmt::format("({:.4g}, {:.4g})", point[0], point[1]);
  }



  void
  refuse_file(const std::string &sentence)
  {
    throw InputError({sentence});
  }
} // namespace PlateImpact
