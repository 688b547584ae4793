#include "plate_impact/plate/plate_mesh.h"

#include <deal.II/base/numbers.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Lengths of n cells along an axis, with a vertex at the impact.
    std::vector<double>
    cell_lengths(const PlateParameters &plate,
                 const unsigned int     d,
                 const unsigned int     n)
    {
      const unsigned int before = plate.cells_before_impact(d, n);
      if (before == 0)
        return std::vector<double>(n, (plate.end(d) - plate.begin(d)) / n);
      std::vector<double> lengths(before, -plate.begin(d) / before);
      lengths.resize(n, plate.end(d) / (n - before));
      return lengths;
    }
  } // namespace



  namespace
  {
    /// What symmetry leaves of a circle, which is centred at -impact_point.
    void
    make_circle(Triangulation<2> &mesh, const PlateParameters &plate)
    {
      const double radius         = 0.5 * plate.side_length(0);
      const bool   is_symmetric[] = {plate.is_symmetric(0),
                                     plate.is_symmetric(1)};
      if (is_symmetric[0] && is_symmetric[1])
        GridGenerator::quarter_hyper_ball(mesh, Point<2>(), radius);
      else if (is_symmetric[0] || is_symmetric[1])
        {
          // x > 0, or turned to y > 0
          GridGenerator::half_hyper_ball(mesh, Point<2>(), radius);
          if (is_symmetric[1])
            GridTools::rotate(0.5 * numbers::PI, mesh);
        }
      else
        GridGenerator::hyper_ball_balanced(mesh, Point<2>(), radius);
      const Point<2> centre(-plate.impact_point[0], -plate.impact_point[1]);
      GridTools::shift(centre, mesh);

      mesh.reset_all_manifolds();
      const double tolerance = 1e-10 * radius;
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary())
          {
            face->set_boundary_id(edge_round);
            for (const unsigned int d : {0, 1})
              if (is_symmetric[d] && std::abs(face->vertex(0)[d]) < tolerance &&
                  std::abs(face->vertex(1)[d]) < tolerance)
                {
                  face->set_boundary_id(d == 0 ? symmetry_x : symmetry_y);
                  // on the plane, whatever the rotation has rounded
                  for (const unsigned int v : {0, 1})
                    face->vertex(v)[d] = 0.;
                }
            if (face->boundary_id() == edge_round)
              face->set_manifold_id(0);
          }
      mesh.set_manifold(0, SphericalManifold<2>(centre));
    }



    /// The mesh of a file, arcs as manifolds.
    void
    make_mesh(Triangulation<2>           &mesh,
              const PlateFile            &file,
              const dealii::Tensor<1, 2> &impact)
    {
      std::vector<Point<2>> vertices;
      for (const auto &[x, y] : file.vertices)
        vertices.push_back(Point<2>(x, y) - impact);
      std::vector<CellData<2>> cells(file.cells.size());
      for (std::size_t c = 0; c < cells.size(); ++c)
        // counterclockwise there, by rows here
        for (const auto &[here, there] :
             {std::pair(0, 0), {1, 1}, {2, 3}, {3, 2}})
          cells[c].vertices[here] = file.cells[c][there];
      SubCellData sides;
      for (const PlateFile::Side &side : file.sides)
        {
          CellData<1> line;
          line.vertices    = {side.vertices[0], side.vertices[1]};
          line.boundary_id = edge_named + side.edge;
          if (side.arc)
            line.manifold_id = *side.arc;
          sides.boundary_lines.push_back(line);
        }
      GridTools::consistently_order_cells(cells);
      mesh.create_triangulation(vertices, cells, sides);
      for (std::size_t arc = 0; arc < file.arcs.size(); ++arc)
        {
          const auto &[x, y] = file.arcs[arc].centre;
          mesh.set_manifold(arc, SphericalManifold<2>(Point<2>(x, y) - impact));
        }
    }
  } // namespace



  std::unique_ptr<Triangulation<2>>
  make_plate_mesh(const PlateParameters             &plate,
                  const std::array<unsigned int, 2> &n_cells)
  {
    auto mesh = std::make_unique<Triangulation<2>>(
      Triangulation<2>::limit_level_difference_at_vertices);
    if (plate.is_circle())
      {
        make_circle(*mesh, plate);
        while (mesh->n_active_cells() < n_cells[0] * n_cells[1])
          mesh->refine_global();
        return mesh;
      }
    if (plate.is_from_file())
      {
        make_mesh(*mesh,
                  *plate.file,
                  Point<2>(plate.impact_point[0], plate.impact_point[1]));
        return mesh;
      }
    const Point<2> begin(plate.begin(0), plate.begin(1)),
      end(plate.end(0), plate.end(1));
    // `colorize` numbers the sides as PlateBoundary does
    if (begin == Point<2>())
      GridGenerator::subdivided_hyper_rectangle(*mesh,
                                                {n_cells[0], n_cells[1]},
                                                begin,
                                                end,
                                                /*colorize=*/true);
    else
      GridGenerator::subdivided_hyper_rectangle(
        *mesh,
        {cell_lengths(plate, 0, n_cells[0]),
         cell_lengths(plate, 1, n_cells[1])},
        begin,
        end,
        /*colorize=*/true);
    for (const auto &face : mesh->active_face_iterators())
      {
        if (!plate.is_symmetric(0) && face->at_boundary() &&
            face->boundary_id() == symmetry_x)
          face->set_boundary_id(edge_x);
        if (!plate.is_symmetric(1) && face->at_boundary() &&
            face->boundary_id() == symmetry_y)
          face->set_boundary_id(edge_y);
      }
    return mesh;
  }



  double
  n_initial_cells(const Parameters &parameters)
  {
    const auto &n_cells = parameters.discretization.initial_cells;
    if (parameters.plate.is_from_file())
      return parameters.plate.file->cells.size();
    return static_cast<double>(n_cells[0]) * n_cells[1];
  }



  double
  initial_cell_size(const Parameters &parameters)
  {
    const PlateParameters &plate   = parameters.plate;
    const auto            &n_cells = parameters.discretization.initial_cells;
    double                 longest = 0.;
    if (plate.is_from_file())
      return plate.file->longest_side;
    if (plate.is_circle())
      {
        const auto mesh = make_plate_mesh(plate, n_cells);
        for (const auto &cell : mesh->active_cell_iterators())
          longest = std::max(longest, cell_size(cell));
        return longest;
      }
    for (unsigned int d = 0; d < 2; ++d)
      for (const double length : cell_lengths(plate, d, n_cells[d]))
        longest = std::max(longest, length);
    return longest;
  }



  const Mapping<2> &
  curved_mapping()
  {
    static const MappingQ<2> mapping(2);
    return mapping;
  }



  namespace
  {
    const Mapping<2> &
    bilinear_mapping()
    {
      static const MappingQ1<2> mapping;
      return mapping;
    }
  } // namespace



  const Mapping<2> &
  mapping_of(const Triangulation<2>::cell_iterator &cell)
  {
    if (cell->at_boundary())
      for (const auto &face : cell->face_iterators())
        if (face->manifold_id() != numbers::flat_manifold_id)
          return curved_mapping();
    return bilinear_mapping();
  }



  const Mapping<2> &
  mapping_of(const Triangulation<2> &mesh)
  {
    for (const types::manifold_id id : mesh.get_manifold_ids())
      if (id != numbers::flat_manifold_id)
        return curved_mapping();
    return bilinear_mapping();
  }



  std::unique_ptr<Triangulation<2>>
  copy_of(const Triangulation<2> &mesh)
  {
    auto copy = std::make_unique<Triangulation<2>>();
    copy->copy_triangulation(mesh);
    return copy;
  }



  double
  cell_size(const Triangulation<2>::cell_iterator &cell)
  {
    double longest = 0.;
    for (const unsigned int face : cell->face_indices())
      longest = std::max(longest, cell->face(face)->diameter());
    return longest;
  }



  double
  smallest_cell_size(const Triangulation<2> &mesh)
  {
    double smallest = std::numeric_limits<double>::max();
    for (const auto &cell : mesh.active_cell_iterators())
      smallest = std::min(smallest, cell_size(cell));
    return smallest;
  }



  bool
  is_near_load(const Triangulation<2>::cell_iterator &cell,
               const double                           half_length,
               const double                           distance)
  {
    const auto [low, high] = cell->bounding_box().get_boundary_points();
    const double dx =
                   std::max({0., low[0] - half_length, -half_length - high[0]}),
                 dy = std::max({0., low[1], -high[1]});
    return std::hypot(dx, dy) <= distance + 1e-9 * cell_size(cell);
  }



  std::pair<double, double>
  cell_sizes_near_load(const Triangulation<2> &mesh,
                       const double            half_length,
                       const double            distance)
  {
    double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      if (is_near_load(cell, half_length, distance))
        {
          smallest = std::min(smallest, cell_size(cell));
          largest  = std::max(largest, cell_size(cell));
        }
    return {smallest, largest};
  }
} // namespace PlateImpact
