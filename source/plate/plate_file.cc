#include "plate_impact/plate/plate_file.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/numerics/rtree.h>

#include "plate_impact/plate/msh_file.h"
#include "plate_impact/plate/plate_mesh.h"

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Two vertices, the lower number first.
    using VertexPair = std::pair<unsigned int, unsigned int>;

    /// Of a cell, counterclockwise.
    using Corners = std::array<Point<2>, 4>;


    /// Coordinates for a sentence.
    std::string
    place(const Point<2> &point)
    {
      return fmt::format("({:.4g}, {:.4g})", point[0], point[1]);
    }



    /// Twice the area of a triangle, positive counterclockwise.
    double
    cross(const Point<2> &a, const Point<2> &b, const Point<2> &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }



    /// The cells of a plate, checked before deal.II sees them.
    struct Cells
    {
      std::vector<Point<2>>             vertices;
      std::vector<CellData<2>>          cells;
      std::map<VertexPair, std::size_t> edge_of_side;
      double                            tolerance; ///< for equal points [m]
      std::vector<Corners>              corners;
    };



    /// Fills in the names of edges, and the edge of each side of a cell that is
    /// in a group.
    void
    add_edges(const MshFile                   &file,
              const std::vector<unsigned int> &vertex_of_node,
              std::vector<std::string>        &edges,
              Cells                           &cells)
    {
      const auto cannot_be_named = [](const unsigned char c) {
        return c < ' ' || std::string(",:#\"\x7f").find(c) != std::string::npos;
      };
      std::map<unsigned int, std::size_t> edge_of_group;
      for (const auto &[group, name] : file.groups)
        {
          if (std::any_of(name.begin(), name.end(), cannot_be_named))
            refuse_file("has a physical group '" + name +
                        "', which no scene can name; expected no comma, "
                        "colon, # or control character in it");
          edge_of_group[group] = edges.size();
          edges.push_back(name);
        }
      for (const MshFile::Side &side : file.sides)
        {
          const VertexPair pair = std::minmax(
            {vertex_of_node[side.nodes[0]], vertex_of_node[side.nodes[1]]});
          if (pair.second == numbers::invalid_unsigned_int)
            continue;
          const std::size_t edge     = edge_of_group.at(side.group);
          const auto [known, is_new] = cells.edge_of_side.insert({pair, edge});
          if (!is_new && known->second != edge)
            refuse_file("has a side at " + place(cells.vertices[pair.first]) +
                        " in two physical groups, '" + edges[known->second] +
                        "' and '" + edges[edge] + "'; expected one");
        }
    }



    Cells
    cells_of(const MshFile &file, std::vector<std::string> &edges)
    {
      Cells                     result{{}, file.cells, {}, 0., {}};
      std::vector<unsigned int> vertex_of_node(file.nodes.size(),
                                               numbers::invalid_unsigned_int);
      std::vector<Point<3>>     used;
      for (auto &cell : result.cells)
        for (unsigned int &node : cell.vertices)
          {
            unsigned int &vertex = vertex_of_node[node];
            if (vertex == numbers::invalid_unsigned_int)
              {
                const Point<3> &p = file.nodes[node];
                if (!(std::isfinite(p[0]) && std::isfinite(p[1])))
                  refuse_file("has a vertex whose coordinates are no numbers");
                vertex = used.size();
                used.push_back(p);
                result.vertices.emplace_back(p[0], p[1]);
              }
            node = vertex;
          }
      const BoundingBox<3> box(used);
      const double size = std::max(box.side_length(0), box.side_length(1));
      if (!(box.side_length(2) <= 1e-6 * size))
        refuse_file("does not lie in a plane of constant z; expected a flat "
                    "plate along x and y");
      result.tolerance = 1e-9 * size;
      add_edges(file, vertex_of_node, edges, result);
      return result;
    }



    /// Fills in the corners of cells, and turns these counterclockwise.
    void
    orient(Cells &cells)
    {
      for (auto &cell : cells.cells)
        {
          Corners &c = cells.corners.emplace_back();
          for (unsigned int v = 0; v < 4; ++v)
            // by rows there, around the cell here
            c[v] = cells.vertices[cell.vertices[v ^ (v / 2)]];
          if (cross(c[0], c[1], c[2]) + cross(c[0], c[2], c[3]) < 0.)
            {
              std::swap(cell.vertices[1], cell.vertices[2]);
              std::swap(c[1], c[3]);
            }
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Point<2> &next = c[(v + 1) % 4], &last = c[(v + 3) % 4];
              if (!(cross(c[v], next, last) >
                    1e-6 * c[v].distance(next) * c[v].distance(last)))
                refuse_file("has a cell at " + place(c[v]) +
                            " with a corner of 180 degrees or more; expected "
                            "convex quadrilaterals");
            }
        }
    }



    /// Vertices in one place that are not one are a crack.
    void
    refuse_cracks(const Cells &cells)
    {
      const auto tree = pack_rtree(cells.vertices);
      for (const Point<2> &vertex : cells.vertices)
        {
          std::vector<Point<2>> nearest; // itself, and another
          tree.query(boost::geometry::index::nearest(vertex, 2),
                     std::back_inserter(nearest));
          if (nearest[0].distance(nearest[1]) <= cells.tolerance)
            refuse_file("has two vertices in one place, " + place(vertex) +
                        ", as along a crack; expected cells that share their "
                        "vertices (in Gmsh: Coherence)");
        }
    }



    void
    refuse_loose_parts(const Cells &cells)
    {
      boost::disjoint_sets_with_storage<> parts(cells.vertices.size());
      for (const auto &cell : cells.cells)
        for (const unsigned int v : cell.vertices)
          parts.union_set(v, cell.vertices[0]);
      for (unsigned int v = 0; v < cells.vertices.size(); ++v)
        if (parts.find_set(v) != parts.find_set(0u))
          refuse_file("has parts that do not touch, at " +
                      place(cells.vertices[0]) + " and " +
                      place(cells.vertices[v]) + "; expected one plate");
    }



    /// Whether the line along one of a convex cell's sides has the other cell
    /// beyond it.
    bool
    is_beside(const Corners &cell, const Corners &other)
    {
      for (unsigned int v = 0; v < 4; ++v)
        {
          const Point<2> &a = cell[v], &b = cell[(v + 1) % 4];
          if (std::all_of(other.begin(), other.end(), [&](const Point<2> &p) {
                return cross(a, b, p) <= 1e-6 * a.distance(b) * a.distance(p);
              }))
            return true;
        }
      return false;
    }



    void
    refuse_overlaps(const Cells &cells)
    {
      const auto                 &corners = cells.corners;
      std::vector<BoundingBox<2>> boxes;
      for (const Corners &of_cell : corners)
        boxes.emplace_back(of_cell);
      const auto tree = pack_rtree_of_indices(boxes);
      for (std::size_t c = 0; c < corners.size(); ++c)
        {
          std::vector<std::size_t> others;
          tree.query(boost::geometry::index::intersects(boxes[c]),
                     std::back_inserter(others));
          for (const std::size_t other : others)
            if (other < c && !is_beside(corners[c], corners[other]) &&
                !is_beside(corners[other], corners[c]))
              refuse_file("has overlapping cells at " + place(corners[c][0]) +
                          "; expected cells side by side, each once (in Gmsh: "
                          "every surface in one physical group)");
        }
    }



    /// Boundary ids of the edges; sides in no group are one edge more.
    void
    set_edges(const std::map<VertexPair, std::size_t> &edge_of_side,
              PlateFile                               &plate)
    {
      const std::size_t nameless = plate.edges.size();
      std::vector<bool> is_used(nameless + 1, false);
      for (const auto &face : plate.mesh.active_face_iterators())
        if (face->at_boundary())
          {
            const auto found = edge_of_side.find(
              std::minmax({face->vertex_index(0), face->vertex_index(1)}));
            const std::size_t edge =
              found == edge_of_side.end() ? nameless : found->second;
            is_used[edge] = true;
            face->set_boundary_id(edge_named + edge);
          }
      for (std::size_t edge = 0; edge < nameless; ++edge)
        if (!is_used[edge])
          refuse_file(
            "has a physical group '" + plate.edges[edge] +
            "' that is no edge of the plate; expected curves along its "
            "boundary");
      if (is_used[nameless])
        plate.edges.emplace_back();
    }



    /// Two sides of a cell on one arc meet at 180 degrees.
    void
    refuse_flat_corners(const Triangulation<2> &mesh)
    {
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto one   = cell->face(v % 2)->manifold_id(),
                       other = cell->face(2 + v / 2)->manifold_id();
            if (one == other && one != numbers::flat_manifold_id)
              refuse_file(
                "has a cell at " + place(cell->vertex(v)) +
                " with two sides on one round edge, where they meet "
                "without a corner; expected one side a cell (in Gmsh: not "
                "Transfinite on a disc)");
          }
    }



    /// With what follows from it.
    void
    draw_outline(PlateFile &plate)
    {
      std::vector<Point<2>> ends;
      for (const auto &face : plate.mesh.active_face_iterators())
        if (face->at_boundary())
          {
            const types::manifold_id id = face->manifold_id();
            const unsigned int n    = id == numbers::flat_manifold_id ? 1 : 16;
            Point<2>           last = face->vertex(0);
            for (unsigned int i = 1; i <= n; ++i)
              {
                const Point<2> next = i == n ?
                  face->vertex(1) :
                  plate.mesh.get_manifold(id).get_intermediate_point(
                    face->vertex(0),
                    face->vertex(1),
                    double(i) / n);
                plate.outline.push_back({{last, next}});
                ends.insert(ends.end(), {last, next});
                last = next;
              }
          }
      // arcs included
      const BoundingBox<2> box(ends);
      plate.extent = {{box.side_length(0), box.side_length(1)}};
      plate.centre = box.center();
    }



    /// Where a chord meets the line through a point along an axis, if it does.
    std::optional<double>
    crossing(const std::array<Point<2>, 2> &chord,
             const Point<2>                &point,
             const unsigned int             axis)
    {
      const auto &[a, b]        = chord;
      const unsigned int across = 1 - axis;
      if ((a[across] > point[across]) == (b[across] > point[across]))
        return {};
      return a[axis] +
        (point[across] - a[across]) / (b[across] - a[across]) *
        (b[axis] - a[axis]);
    }
  } // namespace



  double
  PlateFile::distance_to_edge(const Point<2> &point) const
  {
    using Segment    = boost::geometry::model::segment<Point<2>>;
    double nearest   = std::numeric_limits<double>::max();
    bool   is_inside = false;
    for (const auto &chord : outline)
      {
        nearest =
          std::min(nearest,
                   boost::geometry::distance(point,
                                             Segment(chord[0], chord[1])));
        // a ray along x leaves the plate an odd number of times
        const auto x = crossing(chord, point, 0);
        is_inside ^= x && point[0] < *x;
      }
    return is_inside ? nearest : -nearest;
  }



  double
  PlateFile::distance_to_edge(const Point<2>    &point,
                              const unsigned int axis) const
  {
    double nearest = std::numeric_limits<double>::max();
    for (const auto &chord : outline)
      if (const auto there = crossing(chord, point, axis))
        nearest = std::min(nearest, std::abs(*there - point[axis]));
    return distance_to_edge(point) < 0. ? -nearest : nearest;
  }



  std::shared_ptr<const PlateFile>
  read_plate_file(const std::string &path)
  {
    auto plate  = std::make_shared<PlateFile>();
    plate->path = path;
    Cells cells = cells_of(read_msh_file(path), plate->edges);
    orient(cells);
    refuse_cracks(cells);
    refuse_loose_parts(cells);
    refuse_overlaps(cells);
    GridTools::consistently_order_cells(cells.cells);
    plate->mesh.create_triangulation(cells.vertices, cells.cells, {});
    set_edges(cells.edge_of_side, *plate);
    plate->arcs = find_arcs(plate->mesh);
    refuse_flat_corners(plate->mesh);
    plate->area = GridTools::volume(plate->mesh, curved_mapping());
    draw_outline(*plate);
    return plate;
  }
} // namespace PlateImpact
