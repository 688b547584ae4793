#include "plate_impact/adaptation/remeshing.h"

#include <deal.II/grid/grid_tools.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

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



    double
    rounded_size(const double size)
    {
      return std::exp2(std::round(sizes_per_octave * std::log2(size)) /
                       sizes_per_octave);
    }



    /// Sizes at the vertices: the smallest that their cells need, nowhere
    /// growing faster than the gradation.
    std::vector<double>
    sizes_at_vertices(const Triangulation<2>    &mesh,
                      const std::vector<double> &cell_sizes)
    {
      std::vector<double> sizes(mesh.n_vertices(),
                                std::numeric_limits<double>::infinity());
      // includes the coarse cell at a hanging vertex
      const auto cells = GridTools::vertex_to_cell_map(mesh);
      for (unsigned int vertex = 0; vertex < cells.size(); ++vertex)
        for (const auto &cell : cells[vertex])
          sizes[vertex] =
            std::min(sizes[vertex], cell_sizes[cell->active_cell_index()]);

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



    SizeField
    size_field(const Triangulation<2>    &mesh,
               const std::vector<double> &cell_sizes)
    {
      const std::vector<double> sizes = sizes_at_vertices(mesh, cell_sizes);
      SizeField                 field;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          field.patches.emplace_back();
          unsigned int i = 0;
          for (const unsigned int v : {0, 1, 3, 2}) // counter-clockwise
            {
              field.patches.back().corners[i] = {
                {cell->vertex(v)[0], cell->vertex(v)[1]}};
              field.patches.back().sizes[i++] = sizes[cell->vertex_index(v)];
            }
        }
      return field;
    }



    /// Corners of a rectangle.
    struct Rectangle
    {
      Point<2> begin, end;
    };

    Rectangle
    rectangle_around(const Triangulation<2> &mesh)
    {
      const auto box = GridTools::compute_bounding_box(mesh);
      return {box.get_boundary_points().first,
              box.get_boundary_points().second};
    }



    /// The side of the mesh that a face of the boundary lies on. Planes of
    /// symmetry go through the impact, edges of the plate do not.
    PlateBoundary
    side_of(const Triangulation<2>::face_iterator &face, const Rectangle &sides)
    {
      const auto lies_on = [&face](const unsigned int d, const double value) {
        return face->vertex(0)[d] == value && face->vertex(1)[d] == value;
      };
      if (lies_on(0, sides.begin[0]))
        return sides.begin[0] == 0. ? symmetry_x : edge_x;
      if (lies_on(1, sides.begin[1]))
        return sides.begin[1] == 0. ? symmetry_y : edge_y;
      if (lies_on(0, sides.end[0]))
        return edge_x;
      AssertThrow(lies_on(1, sides.end[1]),
                  ExcMessage("a face of the boundary lies on no side"));
      return edge_y;
    }



    void
    rebuild(Triangulation<2> &mesh,
            const QuadMesh   &quads,
            const Rectangle  &sides)
    {
      std::vector<Point<2>> vertices;
      for (const PlanePoint &vertex : quads.vertices)
        vertices.emplace_back(vertex[0], vertex[1]);
      std::vector<CellData<2>> cells;
      for (const auto &quad : quads.cells)
        {
          cells.emplace_back(4);
          cells.back().vertices = {quad[0], quad[1], quad[3], quad[2]};
        }
      SubCellData faces;
      GridTools::delete_unused_vertices(vertices, cells, faces);
      GridTools::consistently_order_cells(cells);
      mesh.clear();
      mesh.create_triangulation(vertices, cells, faces);
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary())
          face->set_boundary_id(side_of(face, sides));
    }
  } // namespace



  Remeshing::Remeshing(const AdaptivityParameters &adaptivity,
                       const double                contact_half_length,
                       const QuadMesher           &mesher)
    : adaptivity(adaptivity)
    , contact_half_length(contact_half_length)
    , mesher(mesher)
  {}



  std::vector<double>
  Remeshing::wanted_sizes(const Triangulation<2> &mesh,
                          const ErrorOverLimit   &error) const
  {
    std::vector<double> sizes = target_sizes(mesh, error, adaptivity);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        double      &size    = sizes[cell->active_cell_index()];
        const double present = cell_size(cell);
        size                 = size < present ?
                          std::max(refinement_margin * size,
                   std::min(adaptivity.minimum_cell_size, present)) :
                          std::max(size / growth_margin, present);
        size                 = allowed_size(rounded_size(size), adaptivity);
      }
    return sizes;
  }



  bool
  Remeshing::is_worth_it(const Triangulation<2>    &mesh,
                         const ErrorOverLimit      &error,
                         const std::vector<double> &sizes) const
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



  Remeshing::Outline
  Remeshing::outline(const Triangulation<2> &mesh) const
  {
    const auto [begin, end] = rectangle_around(mesh);
    // the impact and the ends of a line contact
    std::vector<PlanePoint> on_axis = {{{0., 0.}}};
    for (const double x : {-contact_half_length, contact_half_length})
      if (contact_half_length > 0. && x > begin[0] && x < end[0])
        on_axis.push_back({{x, 0.}});
    std::sort(on_axis.begin(), on_axis.end());

    Outline result;
    result.corners = {{{begin[0], begin[1]}},
                      {{end[0], begin[1]}},
                      {{end[0], end[1]}},
                      {{begin[0], end[1]}}};
    for (const PlanePoint &point : on_axis)
      if (begin[1] < 0. && begin[0] < point[0])
        result.inside.push_back(point);
      else if (begin[1] < 0.) // on the plane x = 0
        result.corners.push_back(point);
      else if (begin[0] < point[0]) // on the plane y = 0
        result.corners.insert(result.corners.end() - 3, point);
    return result;
  }



  bool
  Remeshing::adapt(Triangulation<2>         &mesh,
                   const ErrorOverLimit     &error,
                   std::vector<std::string> &warnings) const
  {
    for (const types::boundary_id id : mesh.get_boundary_ids())
      if (id >= edge_round)
        throw ComputationError("remeshing makes meshes of rectangles only");
    const std::vector<double> sizes = wanted_sizes(mesh, error);
    if (!is_worth_it(mesh, error, sizes))
      return false;
    const Outline domain = outline(mesh);
    rebuild(mesh,
            mesher.mesh(domain.corners,
                        size_field(mesh, sizes),
                        warnings,
                        domain.inside),
            rectangle_around(mesh));
    return true;
  }



  double
  Remeshing::n_wanted_cells(const Triangulation<2> &mesh,
                            const ErrorOverLimit   &error) const
  {
    return n_cells_of_sizes(mesh, wanted_sizes(mesh, error), adaptivity);
  }
} // namespace PlateImpact
