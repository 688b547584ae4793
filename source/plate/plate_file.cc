#include "plate_impact/plate/plate_file.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/numerics/rtree.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/msh_file.h"
#include "plate_impact/plate/plate_mesh.h"

#include <Eigen/Dense>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
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



    std::vector<Corners>
    convex_corners(const std::vector<CellData<2>> &cells,
                   const std::vector<Point<2>>    &vertices)
    {
      std::vector<Corners> corners;
      for (const auto &cell : cells)
        {
          Corners &c = corners.emplace_back();
          for (unsigned int v = 0; v < 4; ++v)
            // by rows there, around the cell here
            c[v] = vertices[cell.vertices[v ^ (v / 2)]];
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Point<2> &next = c[(v + 1) % 4], &last = c[(v + 3) % 4];
              if (!(cross(c[v], next, last) >
                    1e-6 * c[v].distance(next) * c[v].distance(last)))
                throw InputError({"has a cell at " + place(c[v]) +
                                  " with a corner of 180 degrees or more; "
                                  "expected convex quadrilaterals"});
            }
        }
      return corners;
    }



    /// Vertices in one place that are not one are a crack.
    void
    refuse_cracks(const std::vector<Point<2>> &vertices, const double size)
    {
      const auto tree = pack_rtree(vertices);
      for (const Point<2> &vertex : vertices)
        {
          std::vector<Point<2>> nearest; // itself, and another
          tree.query(boost::geometry::index::nearest(vertex, 2),
                     std::back_inserter(nearest));
          if (nearest[0].distance(nearest[1]) <= 1e-9 * size)
            throw InputError(
              {"has two vertices in one place, " + place(vertex) +
               ", as along a crack; expected cells that share their vertices "
               "(in Gmsh: Coherence)"});
        }
    }



    void
    refuse_loose_parts(const std::vector<CellData<2>> &cells,
                       const std::vector<Point<2>>    &vertices)
    {
      boost::disjoint_sets_with_storage<> parts(vertices.size());
      for (const auto &cell : cells)
        for (const unsigned int v : cell.vertices)
          parts.union_set(v, cell.vertices[0]);
      for (unsigned int v = 0; v < vertices.size(); ++v)
        if (parts.find_set(v) != parts.find_set(0u))
          throw InputError({"has parts that do not touch, at " +
                            place(vertices[0]) + " and " + place(vertices[v]) +
                            "; expected one plate"});
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
    refuse_overlaps(const std::vector<Corners> &corners)
    {
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
              throw InputError(
                {"has overlapping cells at " + place(corners[c][0]) +
                 "; expected cells side by side, each once (in Gmsh: every "
                 "surface in one physical group)"});
        }
    }



    /// Boundary ids of the edges; sides in no group are one edge more.
    void
    set_edges(const MshFile &file, PlateFile &plate)
    {
      plate.edges                = file.edges;
      const std::size_t nameless = plate.edges.size();
      std::vector<bool> is_used(nameless + 1, false);
      for (const auto &face : plate.mesh.active_face_iterators())
        if (face->at_boundary())
          {
            const auto found = file.edge_of_side.find(
              std::minmax({face->vertex_index(0), face->vertex_index(1)}));
            const std::size_t edge =
              found == file.edge_of_side.end() ? nameless : found->second;
            is_used[edge] = true;
            face->set_boundary_id(edge_named + edge);
          }
      for (std::size_t edge = 0; edge < nameless; ++edge)
        if (!is_used[edge])
          throw InputError({"has a physical group '" + plate.edges[edge] +
                            "' that is no edge of the plate; expected curves "
                            "along its boundary"});
      if (is_used[nameless])
        plate.edges.emplace_back();
    }



    using Side = Triangulation<2>::face_iterator;

    /// The sides of the same edge beyond the ends of each side.
    using Neighbours = std::map<Side, std::vector<Side>>;



    Neighbours
    neighbours_of_sides(const Triangulation<2> &mesh)
    {
      std::map<unsigned int, std::vector<Side>> sides_at; // a vertex
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary())
          for (const unsigned int v : {0, 1})
            sides_at[face->vertex_index(v)].push_back(face);
      Neighbours neighbours;
      for (const auto &[vertex, sides] : sides_at)
        if (sides.size() == 2 &&
            sides[0]->boundary_id() == sides[1]->boundary_id())
          {
            neighbours[sides[0]].push_back(sides[1]);
            neighbours[sides[1]].push_back(sides[0]);
          }
      return neighbours;
    }



    /// The circle that fits the ends of sides best in the sense of Kasa: x^2 +
    /// y^2 is linear in x and y on it.
    Arc
    fitted_circle(const std::vector<Side> &sides)
    {
      // from one of them, for the sake of rounding
      const Point<2>  origin = sides.front()->vertex(0);
      Eigen::MatrixXd A(2 * sides.size(), 3);
      Eigen::VectorXd b(A.rows());
      for (Eigen::Index i = 0; i < A.rows(); ++i)
        {
          const Tensor<1, 2> p = sides[i / 2]->vertex(i % 2) - origin;
          A.row(i) << 2. * p[0], 2. * p[1], 1.;
          b[i] = p.norm_square();
        }
      const Eigen::Vector3d c = A.colPivHouseholderQr().solve(b);
      return {origin + Point<2>(c[0], c[1]),
              std::sqrt(std::max(0., c[2] + c[0] * c[0] + c[1] * c[1]))};
    }



    /// Whether a side is a chord of the circle, one of nine or more to a turn:
    /// a polygon of fewer sides is taken for one.
    bool
    is_chord(const Side &side, const Arc &circle)
    {
      const double widest = 40.001 * numbers::PI / 180.;
      for (const unsigned int v : {0, 1})
        if (!(std::abs(side->vertex(v).distance(circle.centre) -
                       circle.radius) < 1e-5 * circle.radius))
          return false;
      return side->diameter() <= 2. * circle.radius * std::sin(0.5 * widest);
    }



    /// Makes sides of one edge that are chords of a circle, nine or more to a
    /// full turn, parts of arcs: their manifold id is the number of an arc. On
    /// a polygon a simple support is another (Babuska's paradox).
    /// @param mesh  of one level, with boundary ids
    /// @param size  of the plate [m]
    std::vector<Arc>
    find_arcs(Triangulation<2> &mesh, const double size)
    {
      const auto       neighbours = neighbours_of_sides(mesh);
      std::vector<Arc> arcs;
      for (const auto &[side, beside] : neighbours)
        {
          if (side->manifold_id() != numbers::flat_manifold_id ||
              beside.size() != 2 || beside[0] == beside[1])
            continue;
          const Arc circle = fitted_circle({beside[0], side, beside[1]});
          if (!(circle.radius < 100. * size && is_chord(beside[0], circle) &&
                is_chord(side, circle) && is_chord(beside[1], circle)))
            continue;
          // all chords around it, one after the other
          std::vector<Side> row = {side};
          for (std::size_t i = 0; i < row.size(); ++i)
            for (const Side &beyond : neighbours.at(row[i]))
              if (is_chord(beyond, circle) &&
                  std::find(row.begin(), row.end(), beyond) == row.end())
                row.push_back(beyond);
          for (const Side &chord : row)
            chord->set_manifold_id(arcs.size());
          arcs.push_back(fitted_circle(row));
          mesh.set_manifold(arcs.size() - 1,
                            SphericalManifold<2>(arcs.back().centre));
        }
      return arcs;
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
              throw InputError(
                {"has a cell at " + place(cell->vertex(v)) +
                 " with two sides on one round edge, where they meet without a "
                 "corner; expected one side a cell (in Gmsh: not Transfinite "
                 "on a disc)"});
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
            const unsigned int n =
              face->manifold_id() == numbers::flat_manifold_id ? 1 : 16;
            Point<2> last = face->vertex(0);
            for (unsigned int i = 1; i <= n; ++i)
              {
                const Point<2> next =
                  face->get_manifold().get_intermediate_point(face->vertex(0),
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
  } // namespace



  std::shared_ptr<const PlateFile>
  read_plate_file(const std::string &path)
  {
    auto plate                = std::make_shared<PlateFile>();
    plate->path               = path;
    MshFile              file = read_msh_file(path);
    const BoundingBox<3> box(file.vertices);
    const double size = std::max(box.side_length(0), box.side_length(1));
    if (!(box.side_length(2) <= 1e-6 * size))
      throw InputError({"does not lie in a plane of constant z; expected a "
                        "flat plate along x and y"});
    std::vector<Point<2>> vertices;
    for (const Point<3> &p : file.vertices)
      vertices.emplace_back(p[0], p[1]);
    GridTools::invert_cells_with_negative_measure(vertices, file.cells);
    const auto corners = convex_corners(file.cells, vertices);
    refuse_cracks(vertices, size);
    refuse_loose_parts(file.cells, vertices);
    refuse_overlaps(corners);
    GridTools::consistently_order_cells(file.cells);
    plate->mesh.create_triangulation(vertices, file.cells, {});
    set_edges(file, *plate);
    plate->arcs = find_arcs(plate->mesh, size);
    refuse_flat_corners(plate->mesh);
    plate->area = GridTools::volume(plate->mesh, curved_mapping());
    draw_outline(*plate);
    return plate;
  }
} // namespace PlateImpact
