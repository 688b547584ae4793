#include "plate_impact/plate/plate_file_overlaps.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    [[noreturn]] void
    refuse(const PlanePoint &point)
    {
      refuse_file("has cells on each other at " + place(point) +
                  "; expected cells side by side, each once (in Gmsh: every "
                  "surface in one physical group)");
    }



    /// Whether a point lies to the left of the line from one to another (1), to
    /// the right (-1) or on it.
    int
    side_of(const PlanePoint &from, const PlanePoint &to, const PlanePoint &p)
    {
      const double area = (to[0] - from[0]) * (p[1] - from[1]) -
        (to[1] - from[1]) * (p[0] - from[0]);
      return (area > 0.) - (area < 0.);
    }



    bool
    cross(const PlateFile  &plate,
          const VertexPair &one,
          const VertexPair &other)
    {
      const PlanePoint &a = plate.vertices[one[0]], &b = plate.vertices[one[1]],
                       &c = plate.vertices[other[0]],
                       &d = plate.vertices[other[1]];
      return side_of(a, b, c) * side_of(a, b, d) < 0 &&
        side_of(c, d, a) * side_of(c, d, b) < 0;
    }



    /// The sides of the boundary, the plate on their left.
    std::vector<VertexPair>
    boundary_of(const PlateFile &plate)
    {
      std::set<VertexPair> sides;
      for (const auto &cell : plate.cells)
        for (unsigned int v = 0; v < 4; ++v)
          sides.insert(VertexPair{{cell[v], cell[(v + 1) % 4]}});
      std::vector<VertexPair> boundary;
      for (const auto &[a, b] : sides)
        if (sides.count(VertexPair{{b, a}}) == 0)
          boundary.push_back({{a, b}});
      return boundary;
    }



    double
    direction(const PlanePoint &from, const PlanePoint &to)
    {
      return std::atan2(to[1] - from[1], to[0] - from[0]);
    }



    /// The corners at a vertex follow each other within a turn.
    void
    refuse_overlapping_corners(const PlateFile &plate)
    {
      const double turn = 2. * std::acos(-1.);
      // by their first directions, with their angles
      std::vector<std::vector<std::array<double, 2>>> corners(
        plate.vertices.size());
      for (const auto &cell : plate.cells)
        for (unsigned int v = 0; v < 4; ++v)
          {
            const auto point = [&](const unsigned int v) -> const PlanePoint & {
              return plate.vertices[cell[v % 4]];
            };
            const double first = direction(point(v), point(v + 1));
            corners[cell[v]].push_back(
              {{first,
                std::remainder(direction(point(v), point(v + 3)) - first,
                               turn)}});
          }
      for (std::size_t v = 0; v < corners.size(); ++v)
        {
          auto &here = corners[v];
          std::sort(here.begin(), here.end());
          here.push_back({{here.front()[0] + turn, 0.}});
          for (std::size_t i = 0; i + 1 < here.size(); ++i)
            if (here[i][0] + here[i][1] > here[i + 1][0] + 1e-6)
              refuse(plate.vertices[v]);
        }
    }



    void
    refuse_crossings(const PlateFile &plate, std::vector<VertexPair> boundary)
    {
      // along the longer extent few of them are beside each other
      const unsigned int along = plate.extent[1] > plate.extent[0] ? 1 : 0;
      const auto         begin = [&](const VertexPair &side) {
        return std::min(plate.vertices[side[0]][along],
                        plate.vertices[side[1]][along]);
      };
      const auto end = [&](const VertexPair &side) {
        return std::max(plate.vertices[side[0]][along],
                        plate.vertices[side[1]][along]);
      };
      std::sort(boundary.begin(),
                boundary.end(),
                [&](const VertexPair &a, const VertexPair &b) {
                  return begin(a) < begin(b);
                });
      for (std::size_t i = 0; i < boundary.size(); ++i)
        for (std::size_t j = i + 1;
             j < boundary.size() && begin(boundary[j]) <= end(boundary[i]);
             ++j)
          if (cross(plate, boundary[i], boundary[j]))
            refuse(plate.vertices[boundary[i][0]]);
    }
  } // namespace



  void
  refuse_overlaps(const PlateFile &plate)
  {
    refuse_overlapping_corners(plate);
    refuse_crossings(plate, boundary_of(plate));
  }
} // namespace PlateImpact
