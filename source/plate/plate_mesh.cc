#include "plate_impact/plate/plate_mesh.h"

#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q1.h>

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  const Mapping<2> &
  curved_mapping()
  {
    static const MappingQ<2> mapping(2);
    return mapping;
  }



  const Mapping<2> &
  mapping_of(const Triangulation<2>::cell_iterator &cell)
  {
    if (cell->at_boundary())
      for (const auto &face : cell->face_iterators())
        if (face->manifold_id() != numbers::flat_manifold_id)
          return curved_mapping();
    return StaticMappingQ1<2>::mapping;
  }



  const Mapping<2> &
  mapping_of(const Triangulation<2> &mesh)
  {
    for (const types::manifold_id id : mesh.get_manifold_ids())
      if (id != numbers::flat_manifold_id)
        return curved_mapping();
    return StaticMappingQ1<2>::mapping;
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
