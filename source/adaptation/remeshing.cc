#include <deal.II/grid/grid_tools.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/adaptation/quad_mesher.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/plate_mesh.h"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Growth of the size over a distance, both in metres: hanging nodes have
    /// neighbours of twice the size.
    constexpr double gradation = 0.5;

    /// Refined cells get their target size times this.
    constexpr double refinement_margin = 0.85;

    /// Cells grow to their target size over this.
    constexpr double growth_margin = 1.6;

    /// Sizes are rounded to so many an octave: the last digits, in which
    /// processors differ, would change Gmsh's whole mesh.
    constexpr double sizes_per_octave = 64.;

    /// Ratio of sizes within which Gmsh's cells scatter.
    constexpr double scatter = 1.25;



    /// Sizes at the vertices: the smallest that their cells need, nowhere
    /// growing faster than the gradation.
    std::vector<double>
    sizes_at_vertices(const Triangulation<2>     &mesh,
                      const std::vector<double>  &cell_sizes,
                      const AdaptivityParameters &adaptivity)
    {
      std::vector<double> sizes(mesh.n_vertices(),
                                std::numeric_limits<double>::infinity());
      // includes the coarse cell at a hanging vertex
      const auto cells = GridTools::vertex_to_cell_map(mesh);
      for (unsigned int vertex = 0; vertex < cells.size(); ++vertex)
        for (const auto &cell : cells[vertex])
          sizes[vertex] =
            std::min(sizes[vertex],
                     CellSizing(cell, adaptivity)
                       .at(mesh.get_vertices()[vertex],
                           cell_sizes[cell->active_cell_index()]));

      for (bool is_changed = true; is_changed;)
        {
          is_changed = false;
          for (const auto &cell : mesh.active_cell_iterators())
            for (const unsigned int v : cell->vertex_indices())
              for (const unsigned int w : cell->vertex_indices())
                {
                  const double limit = sizes[cell->vertex_index(w)] +
                    gradation * cell->vertex(v).distance(cell->vertex(w));
                  double &size = sizes[cell->vertex_index(v)];
                  if (size > limit * (1. + 1e-12))
                    {
                      size       = limit;
                      is_changed = true;
                    }
                }
        }
      return sizes;
    }



    /// The first and the last of the rectangle that is meshed.
    using Corners = std::pair<Point<2>, Point<2>>;

    /// The side of the mesh that a face of the boundary lies on. Planes of
    /// symmetry go through the impact, edges of the plate do not.
    PlateBoundary
    side_of(const Triangulation<2>::face_iterator &face, const Corners &sides)
    {
      for (const unsigned int d : {0, 1})
        for (const double side : {sides.first[d], sides.second[d]})
          if (face->vertex(0)[d] == side && face->vertex(1)[d] == side)
            return side == 0. ? (d == 0 ? symmetry_x : symmetry_y) :
                                (d == 0 ? edge_x : edge_y);
      throw std::logic_error("a face of the boundary lies on no side");
    }



    /// Corners of the domain, and vertices within it: the impact and the ends
    /// of a line contact are among them.
    std::pair<std::vector<Point<2>>, std::vector<Point<2>>>
    required_vertices(const Corners &sides, const double contact_half_length)
    {
      const auto &[begin, end] = sides;
      std::vector<Point<2>> corners{begin,
                                    {end[0], begin[1]},
                                    end,
                                    {begin[0], end[1]}},
        inside;
      for (const double x :
           std::set<double>{0., -contact_half_length, contact_half_length})
        if (x == 0. || (x > begin[0] && x < end[0]))
          {
            if (begin[1] < 0. && begin[0] < x)
              inside.emplace_back(x, 0.);
            else if (begin[1] < 0.) // on the plane x = 0
              corners.emplace_back(x, 0.);
            else if (begin[0] < x) // on the plane y = 0
              corners.emplace(corners.end() - 3, x, 0.);
          }
      return {corners, inside};
    }



    /// Whether cells are off their sizes by more than the scatter.
    bool
    is_worth_it(const Triangulation<2>     &mesh,
                const ErrorRatios          &error,
                const std::vector<double>  &sizes,
                const AdaptivityParameters &adaptivity)
    {
      const double limit = error.overall > 1. ? 1. : scatter;
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell_size(cell) / sizes[cell->active_cell_index()] *
              refinement_margin >
            limit)
          return true;
      return n_cells_of_sizes(mesh, sizes, adaptivity) <
        mesh.n_active_cells() / (scatter * scatter);
    }
  } // namespace



  std::vector<double>
  sizes_for_remeshing(const Triangulation<2>     &mesh,
                      const ErrorRatios          &error,
                      const AdaptivityParameters &adaptivity)
  {
    std::vector<double> sizes = target_sizes(mesh, error, adaptivity);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const CellSizing sizing(cell, adaptivity);
        double          &size    = sizes[cell->active_cell_index()];
        const double     present = cell_size(cell);
        size = size < present ? std::max(refinement_margin * size,
                                         std::min(sizing.minimum, present)) :
                                std::max(size / growth_margin, present);
        size = sizing.allowed(std::exp2(
          std::round(sizes_per_octave * std::log2(size)) / sizes_per_octave));
      }
    return sizes;
  }



  bool
  remesh(const Adapting &adapting)
  {
    const auto &[mesh, error, adaptivity, contact_half_length, warnings] =
      adapting;
    for (const types::boundary_id id : mesh.get_boundary_ids())
      if (id >= edge_round)
        throw ComputationError("remeshing makes meshes of rectangles only");
    const std::vector<double> sizes =
      sizes_for_remeshing(mesh, error, adaptivity);
    if (!is_worth_it(mesh, error, sizes, adaptivity))
      return false;
    const Corners sides =
      GridTools::compute_bounding_box(mesh).get_boundary_points();
    const auto [corners, inside] =
      required_vertices(sides, contact_half_length);
    QuadMesh                 quads = mesh_by_gmsh(corners,
                                  inside,
                                  mesh,
                                  sizes_at_vertices(mesh, sizes, adaptivity),
                                  warnings);
    std::vector<CellData<2>> cells;
    for (const auto &quad : quads.cells)
      {
        cells.emplace_back(4);
        cells.back().vertices = {quad[0], quad[1], quad[3], quad[2]};
      }
    SubCellData faces;
    GridTools::delete_unused_vertices(quads.vertices, cells, faces);
    GridTools::consistently_order_cells(cells);
    mesh.clear();
    mesh.create_triangulation(quads.vertices, cells, faces);
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(side_of(face, sides));
    return true;
  }
} // namespace PlateImpact
