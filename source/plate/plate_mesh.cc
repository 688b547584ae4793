#include "plate_impact/plate/plate_mesh.h"

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <limits>

namespace PlateImpact
{
  using namespace dealii;

  std::unique_ptr<Triangulation<2>>
  make_plate_quadrant(const PlateParameters             &plate,
                      const std::array<unsigned int, 2> &n_cells)
  {
    auto mesh = std::make_unique<Triangulation<2>>(
      Triangulation<2>::limit_level_difference_at_vertices);
    // `colorize` numbers the sides as PlateBoundary does
    GridGenerator::subdivided_hyper_rectangle(
      *mesh,
      {n_cells[0], n_cells[1]},
      Point<2>(0., 0.),
      Point<2>(0.5 * plate.side_lengths[0], 0.5 * plate.side_lengths[1]),
      /*colorize=*/true);
    return mesh;
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
} // namespace PlateImpact
