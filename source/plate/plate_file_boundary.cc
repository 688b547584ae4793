#include "plate_impact/plate/plate_file_boundary.h"

#include "plate_impact/plate/boundary_arcs.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace PlateImpact
{
  namespace
  {
    /// Sides of one cell alone, with the groups that they belong to.
    void
    find_sides(PlateFile                                &plate,
               const std::map<VertexPair, unsigned int> &group_of_side)
    {
      std::map<VertexPair, unsigned int> n_cells;
      plate.longest_side = 0.;
      for (const auto &cell : plate.cells)
        for (unsigned int v = 0; v < 4; ++v)
          {
            const unsigned int a = cell[v], b = cell[(v + 1) % 4];
            ++n_cells[sorted(a, b)];
            plate.longest_side =
              std::max(plate.longest_side,
                       distance(plate.vertices[a], plate.vertices[b]));
          }
      std::optional<unsigned int> nameless;
      std::vector<bool>           is_used(plate.edges.size(), false);
      for (const auto &[vertices, n] : n_cells)
        {
          if (n > 1)
            continue;
          const auto   group = group_of_side.find(vertices);
          unsigned int edge  = 0;
          if (group != group_of_side.end())
            {
              edge          = group->second;
              is_used[edge] = true;
            }
          else
            {
              if (!nameless)
                {
                  nameless = plate.edges.size();
                  plate.edges.emplace_back();
                }
              edge = *nameless;
            }
          plate.sides.push_back({vertices, edge, {}});
        }
      if (plate.sides.empty())
        refuse_file("has no boundary; expected every cell once");
      for (std::size_t edge = 0; edge < is_used.size(); ++edge)
        if (!is_used[edge])
          refuse_file(
            "has a physical group '" + plate.edges[edge] +
            "' that is no edge of the plate; expected curves along its "
            "boundary");
    }



    /// Points of a side from its first vertex to its second.
    std::vector<PlanePoint>
    points_along(const PlateFile &plate, const PlateFile::Side &side)
    {
      const PlanePoint &a = plate.vertices[side.vertices[0]],
                       &b = plate.vertices[side.vertices[1]];
      if (!side.arc)
        return {a, b};
      const auto &[middle, radius] = plate.arcs[*side.arc];
      const unsigned int      n    = 16;
      std::vector<PlanePoint> points;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double x     = a[0] + (b[0] - a[0]) * i / n - middle[0],
                       y     = a[1] + (b[1] - a[1]) * i / n - middle[1],
                       scale = radius / std::hypot(x, y);
          points.push_back({{middle[0] + scale * x, middle[1] + scale * y}});
        }
      points.front() = a;
      points.back()  = b;
      return points;
    }



    /// Two sides of a cell on one arc meet at 180 degrees.
    void
    refuse_flat_corners(const PlateFile &plate)
    {
      std::map<VertexPair, unsigned int> arc_of_side;
      for (const PlateFile::Side &side : plate.sides)
        if (side.arc)
          arc_of_side[sorted(side.vertices[0], side.vertices[1])] = *side.arc;
      for (const auto &cell : plate.cells)
        for (unsigned int v = 0; v < 4; ++v)
          {
            const auto one =
                         arc_of_side.find(sorted(cell[v], cell[(v + 1) % 4])),
                       other =
                         arc_of_side.find(sorted(cell[v], cell[(v + 3) % 4]));
            if (one != arc_of_side.end() && other != arc_of_side.end() &&
                one->second == other->second)
              refuse_file(
                "has a cell at " + place(plate.vertices[cell[v]]) +
                " with two sides on one round edge, where they meet "
                "without a corner; expected one side a cell (in Gmsh: not "
                "Transfinite on a disc)");
          }
    }



    void
    draw_outline(PlateFile &plate)
    {
      std::map<VertexPair, std::array<unsigned int, 2>> along_cell;
      for (const auto &cell : plate.cells)
        for (unsigned int v = 0; v < 4; ++v)
          along_cell[sorted(cell[v], cell[(v + 1) % 4])] = {
            {cell[v], cell[(v + 1) % 4]}};
      for (PlateFile::Side &side : plate.sides)
        {
          // the plate on the left
          side.vertices     = along_cell.at(side.vertices);
          const auto points = points_along(plate, side);
          for (std::size_t i = 0; i + 1 < points.size(); ++i)
            plate.outline.push_back({{points[i], points[i + 1]}});
        }
      plate.area = 0.;
      for (const auto &[a, b] : plate.outline)
        plate.area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }



    /// The middle of the rectangle around the plate, arcs included, becomes the
    /// origin.
    void
    centre(PlateFile &plate)
    {
      std::vector<PlanePoint> points;
      for (const auto &chord : plate.outline)
        points.push_back(chord[0]);
      const auto box   = box_around(points);
      plate.extent     = {{box[1][0] - box[0][0], box[1][1] - box[0][1]}};
      const auto shift = [&box](PlanePoint &point) {
        for (const unsigned int d : {0, 1})
          point[d] -= 0.5 * (box[0][d] + box[1][d]);
      };
      for (PlanePoint &vertex : plate.vertices)
        shift(vertex);
      for (PlateFile::Arc &arc : plate.arcs)
        shift(arc.centre);
      for (auto &chord : plate.outline)
        for (PlanePoint &end : chord)
          shift(end);
    }
  } // namespace



  void
  find_boundary(PlateFile                                &plate,
                const std::map<VertexPair, unsigned int> &group_of_side)
  {
    find_sides(plate, group_of_side);
    find_arcs(plate);
    refuse_flat_corners(plate);
    draw_outline(plate);
    centre(plate);
  }
} // namespace PlateImpact
