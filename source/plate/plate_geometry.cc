#include "plate_impact/plate/plate_geometry.h"

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include "plate_impact/plate/plate_file.h"

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/segment.hpp>

#include <cmath>
#include <limits>
#include <list>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    using CellNumbers = std::array<unsigned int, 2>; ///< along x and y


    PlateGeometry
    rectangle(const PlateParameters &plate)
    {
      const auto [a, b]                 = plate.side_lengths;
      const std::array<double, 2> along = {
        {0.5 * a - std::abs(plate.impact_point[0]),
         0.5 * b - std::abs(plate.impact_point[1])}};
      return {plate.side_lengths,
              a * b,
              std::min(along[0], along[1]),
              along,
              {{edge_x, ""}, {edge_y, ""}}};
    }



    /// Lengths of n cells along an axis of a rectangle.
    std::vector<double>
    cell_lengths(const PlateGeometry &plate,
                 const unsigned int   d,
                 const unsigned int   n)
    {
      if (plate.is_symmetric[d] || n == 1)
        return std::vector<double>(n, (plate.end[d] - plate.begin[d]) / n);
      const long before =
        std::clamp<long>(std::lround(-plate.begin[d] / plate.side_lengths[d] *
                                     n),
                         1,
                         n - 1);
      std::vector<double> lengths(before, -plate.begin[d] / before);
      lengths.resize(n, plate.end[d] / (n - before));
      return lengths;
    }



    double
    longest_cell(const PlateGeometry &plate,
                 const unsigned int   d,
                 const unsigned int   n)
    {
      const auto lengths = cell_lengths(plate, d, n);
      return *std::max_element(lengths.begin(), lengths.end());
    }



    /// Rectangular cells, equal in size for an impact at the centre; the impact
    /// is a vertex, unless a single cell lies across an axis.
    void
    mesh_rectangle(const PlateParameters &parameters,
                   const CellNumbers     &n_cells,
                   Triangulation<2>      &mesh)
    {
      const PlateGeometry plate = geometry_of(parameters);
      const Point<2>      corner(plate.begin[0], plate.begin[1]),
        opposite(plate.end[0], plate.end[1]);
      // `colorize` numbers the sides as PlateBoundary does
      if (corner == Point<2>())
        GridGenerator::subdivided_hyper_rectangle(mesh,
                                                  {n_cells[0], n_cells[1]},
                                                  corner,
                                                  opposite,
                                                  /*colorize=*/true);
      else
        GridGenerator::subdivided_hyper_rectangle(
          mesh,
          {cell_lengths(plate, 0, n_cells[0]),
           cell_lengths(plate, 1, n_cells[1])},
          corner,
          opposite,
          /*colorize=*/true);
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary())
          {
            if (!plate.is_symmetric[0] && face->boundary_id() == symmetry_x)
              face->set_boundary_id(edge_x);
            if (!plate.is_symmetric[1] && face->boundary_id() == symmetry_y)
              face->set_boundary_id(edge_y);
          }
    }



    CellNumbers
    rectangle_of_size(const PlateParameters       &parameters,
                      const std::array<double, 2> &longest)
    {
      const PlateGeometry plate  = geometry_of(parameters);
      CellNumbers         result = {{1, 1}};
      for (unsigned int d = 0; d < 2; ++d)
        while (longest_cell(plate, d, result[d]) > longest[d])
          ++result[d];
      return result;
    }



    /// The first side length is the diameter.
    PlateGeometry
    circle(const PlateParameters &plate)
    {
      const double diameter = plate.side_lengths[0], radius = 0.5 * diameter;
      const auto [x, y]  = plate.impact_point;
      const auto to_edge = [radius](const double along, const double across) {
        return std::sqrt(std::max(0., radius * radius - across * across)) -
          std::abs(along);
      };
      return {{{diameter, diameter}},
              0.25 * numbers::PI * diameter * diameter,
              radius - std::hypot(x, y),
              {{to_edge(x, y), to_edge(y, x)}},
              {{edge_round, ""}}};
    }



    /// Round edges, and the planes of symmetry between them.
    void
    mark_circle(const PlateParameters &parameters, Triangulation<2> &mesh)
    {
      const PlateGeometry plate = geometry_of(parameters);
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary())
          {
            face->set_boundary_id(edge_round);
            face->set_manifold_id(0);
            for (const unsigned int d : {0, 1})
              if (plate.is_symmetric[d] &&
                  std::abs(face->center()[d]) <
                    1e-10 * parameters.side_lengths[0])
                {
                  face->set_boundary_id(d == 0 ? symmetry_x : symmetry_y);
                  face->set_manifold_id(numbers::flat_manifold_id);
                  // on the plane, whatever a rotation has rounded
                  for (const unsigned int v : {0, 1})
                    face->vertex(v)[d] = 0.;
                }
          }
      mesh.set_manifold(0,
                        SphericalManifold<2>(
                          Point<2>(-parameters.impact_point[0],
                                   -parameters.impact_point[1])));
    }



    unsigned int
    n_circle_cells(const PlateParameters &parameters, const unsigned int n)
    {
      // five times n x n in a quarter
      return 5 * n * n * (4 / geometry_of(parameters).n_parts());
    }



    /// Around the origin, of radius 1: n x n cells around the centre, and
    /// between them and the edge a ring of two parts of 2 n x n, whose cells
    /// are longer along the edge. Waves from a load run across the ring. About
    /// half as many cells carry them as well as ones as long as wide do, and
    /// most bending is near the load.
    Triangulation<2>
    quarter_of_circle(const unsigned int n)
    {
      // Cells along the axes are equal. The inner part is a little longer along
      // the diagonal, so that cells are the most equal in size.
      const double   side = 1. / 3., diagonal = 1.12 * side;
      const Point<2> corner(diagonal * numbers::SQRT1_2,
                            diagonal * numbers::SQRT1_2);
      const auto     inner = [&](const Point<2> &unit) {
        const auto [x, y] = std::array<double, 2>{{unit[0], unit[1]}};
        return Point<2>(x * (1. - y) * side, y * (1. - x) * side) +
          x * y * corner;
      };
      // from the axis to the diagonal along the ring
      const auto below = [&](const double outwards, const double along) {
        const double angle = 0.25 * numbers::PI * along;
        return (1. - outwards) * inner({1., along}) +
          outwards * Point<2>(std::cos(angle), std::sin(angle));
      };
      const auto part = [](const CellNumbers &n_cells, const auto &place) {
        Triangulation<2> result;
        GridGenerator::subdivided_hyper_rectangle(result,
                                                  {n_cells[0], n_cells[1]},
                                                  Point<2>(),
                                                  Point<2>(1., 1.));
        GridTools::transform(place, result);
        return result;
      };
      const auto parts = std::array<Triangulation<2>, 3>{
        {part({{n, n}}, inner),
         part({{2 * n, n}},
              [&](const Point<2> &unit) { return below(unit[0], unit[1]); }),
         part({{n, 2 * n}}, [&](const Point<2> &unit) {
           const auto mirrored = below(unit[1], unit[0]);
           return Point<2>(mirrored[1], mirrored[0]);
         })}};
      Triangulation<2> result;
      GridGenerator::merge_triangulations({&parts[0], &parts[1], &parts[2]},
                                          result,
                                          1e-3 / n);
      return result;
    }



    /// Of the quarters that symmetry leaves; as many cells as asked for or the
    /// next number that there is. Those at the edge are curved.
    void
    mesh_circle(const PlateParameters &parameters,
                const CellNumbers     &n_cells,
                Triangulation<2>      &mesh)
    {
      unsigned int n = 1;
      while (n_circle_cells(parameters, n) < n_cells[0] * n_cells[1])
        ++n;
      // x > 0 is between the last quarter and the first, y > 0 before the third
      const PlateGeometry                   plate    = geometry_of(parameters);
      const bool                            is_right = plate.is_symmetric[0];
      std::list<Triangulation<2>>           quarters;
      std::vector<const Triangulation<2> *> all;
      for (unsigned int q = 0; q < 4 / plate.n_parts(); ++q)
        {
          quarters.push_back(quarter_of_circle(n));
          GridTools::rotate((is_right ? -0.5 : 0.5) * numbers::PI * q,
                            quarters.back());
          all.push_back(&quarters.back());
        }
      GridGenerator::merge_triangulations(all, mesh, 1e-3 / n);
      GridTools::scale(0.5 * parameters.side_lengths[0], mesh);
      GridTools::shift(Tensor<1, 2>({-parameters.impact_point[0],
                                     -parameters.impact_point[1]}),
                       mesh);
      mark_circle(parameters, mesh);
    }



    /// The sides at the edge are the longest. They may be 2 % longer: halves of
    /// an arc are a little longer than half its chord.
    CellNumbers
    circle_of_size(const PlateParameters       &parameters,
                   const std::array<double, 2> &longest)
    {
      unsigned int n = 1;
      while (parameters.side_lengths[0] * std::sin(numbers::PI / (8. * n)) >
             1.02 * std::max(longest[0], longest[1]))
        ++n;
      return {{n_circle_cells(parameters, n), 1}};
    }



    /// In the coordinates of a file.
    Point<2>
    impact_on(const PlateParameters &plate)
    {
      return plate.file->centre +
        Point<2>(plate.impact_point[0], plate.impact_point[1]);
    }



    PlateGeometry
    plate_of_file(const PlateParameters &plate)
    {
      using Segment           = boost::geometry::model::segment<Point<2>>;
      const PlateFile &file   = *plate.file;
      const Point<2>   impact = impact_on(plate);
      const double     far    = std::numeric_limits<double>::max();
      PlateGeometry    result = {file.extent, file.area, far, {{far, far}}, {}};
      bool             is_inside = false;
      for (const auto &[a, b] : file.outline)
        {
          result.distance_to_edge =
            std::min(result.distance_to_edge,
                     boost::geometry::distance(impact, Segment(a, b)));
          for (const unsigned int axis : {0, 1})
            {
              const unsigned int across = 1 - axis;
              if ((a[across] > impact[across]) == (b[across] > impact[across]))
                continue;
              const double ahead = a[axis] - impact[axis] +
                (impact[across] - a[across]) / (b[across] - a[across]) *
                  (b[axis] - a[axis]);
              result.distance_along[axis] =
                std::min(result.distance_along[axis], std::abs(ahead));
              // a ray along x leaves the plate an odd number of times
              is_inside ^= axis == 0 && ahead > 0.;
            }
        }
      if (!is_inside)
        for (double *distance : {&result.distance_to_edge,
                                 &result.distance_along[0],
                                 &result.distance_along[1]})
          *distance *= -1.;
      for (unsigned int edge = 0; edge < file.edges.size(); ++edge)
        result.edges[edge_named + edge] = file.edges[edge];
      return result;
    }



    /// The cells of the file.
    void
    mesh_of_file(const PlateParameters &plate,
                 const CellNumbers &,
                 Triangulation<2> &mesh)
    {
      const Point<2> impact = impact_on(plate);
      mesh.copy_triangulation(plate.file->mesh);
      GridTools::shift(Point<2>() - impact, mesh);
      for (unsigned int arc = 0; arc < plate.file->arcs.size(); ++arc)
        mesh.set_manifold(arc,
                          SphericalManifold<2>(
                            Point<2>(plate.file->arcs[arc].centre - impact)));
    }



    struct OutlineRow
    {
      PlateOutline choice;
      /// Lengths, area, distances and edges.
      PlateGeometry (*geometry)(const PlateParameters &);
      void (*make_mesh)(const PlateParameters &,
                        const CellNumbers &,
                        Triangulation<2> &);
      /// As n_cells_of_size(); null where a file has the cells.
      CellNumbers (*of_size)(const PlateParameters &,
                             const std::array<double, 2> &) = nullptr;
    };

    const std::vector<OutlineRow> outlines = {
      {PlateOutline::rectangle, rectangle, mesh_rectangle, rectangle_of_size},
      {PlateOutline::circle, circle, mesh_circle, circle_of_size},
      {PlateOutline::file, plate_of_file, mesh_of_file}};
  } // namespace



  PlateGeometry
  geometry_of(const PlateParameters &plate)
  {
    PlateGeometry result =
      row_of(plate.outline.shape, outlines).geometry(plate);
    for (unsigned int d = 0; d < 2; ++d)
      {
        const double half_length = 0.5 * result.side_lengths[d],
                     impact      = plate.impact_point[d];
        result.is_symmetric[d] =
          !plate.is_from_file() && !plate.is_skew && impact == 0.;
        result.begin[d] = result.is_symmetric[d] ? 0. : -half_length - impact;
        result.end[d]   = half_length - impact;
      }
    return result;
  }



  std::unique_ptr<Triangulation<2>>
  make_plate_mesh(const PlateParameters &plate, const CellNumbers &n_cells)
  {
    auto mesh = std::make_unique<Triangulation<2>>(
      Triangulation<2>::limit_level_difference_at_vertices);
    row_of(plate.outline.shape, outlines).make_mesh(plate, n_cells, *mesh);
    return mesh;
  }



  double
  initial_cell_size(const Parameters &parameters)
  {
    const PlateParameters &plate   = parameters.plate;
    const CellNumbers     &n_cells = parameters.discretization.initial_cells;
    if (plate.outline.shape != PlateOutline::rectangle)
      return cell_sizes_near_load(*make_plate_mesh(plate, n_cells),
                                  0.,
                                  std::numeric_limits<double>::infinity())
        .second;
    // without the mesh, which may be too large to make
    const PlateGeometry geometry = geometry_of(plate);
    return std::max(longest_cell(geometry, 0, n_cells[0]),
                    longest_cell(geometry, 1, n_cells[1]));
  }



  CellNumbers
  n_cells_of_size(const PlateParameters &plate, std::array<double, 2> longest)
  {
    for (double &length : longest)
      length *= 1. + 1e-9;
    return row_of(plate.outline.shape, outlines).of_size(plate, longest);
  }
} // namespace PlateImpact
