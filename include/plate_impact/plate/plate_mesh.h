#pragma once

#include <deal.II/fe/mapping.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

namespace PlateImpact
{
  /// Boundary ids of a mesh, which has the impact at the origin.
  enum PlateBoundary : dealii::types::boundary_id
  {
    symmetry_x = 0, ///< the plane of symmetry x = 0
    edge_x     = 1, ///< edges of the plate across x
    symmetry_y = 2, ///< the plane of symmetry y = 0
    edge_y     = 3, ///< edges across y
    edge_round = 4, ///< the edge of a circle
    edge_named = 5  ///< the first edge of a file, followed by the others
  };


  /// Of second order, so that round edges are not polygons, on which a simple
  /// support is another (Babuska's paradox).
  const dealii::Mapping<2> &
  curved_mapping();

  /// curved_mapping() for cells with a curved side, else bilinear.
  const dealii::Mapping<2> &
  mapping_of(const dealii::Triangulation<2>::cell_iterator &cell);

  /// curved_mapping() for meshes that have curved sides.
  const dealii::Mapping<2> &
  mapping_of(const dealii::Triangulation<2> &mesh);

  inline std::unique_ptr<dealii::Triangulation<2>>
  copy_of(const dealii::Triangulation<2> &mesh)
  {
    auto copy = std::make_unique<dealii::Triangulation<2>>();
    copy->copy_triangulation(mesh);
    return copy;
  }

  /// Size h of a cell: its longest side, which is what resolves a field. [m]
  inline double
  cell_size(const dealii::Triangulation<2>::cell_iterator &cell)
  {
    double longest = 0.;
    for (const unsigned int face : cell->face_indices())
      longest = std::max(longest, cell->face(face)->diameter());
    return longest;
  }

  /// The largest extents of active cells along their own two axes. [m]
  inline std::array<double, 2>
  longest_extents(const dealii::Triangulation<2> &mesh)
  {
    std::array<double, 2> longest{};
    for (const auto &cell : mesh.active_cell_iterators())
      for (unsigned int d = 0; d < 2; ++d)
        longest[d] = std::max(longest[d], cell->extent_in_direction(d));
    return longest;
  }

  /// Whether a point is inside a cell or at one of its vertices.
  inline bool
  touches_point(const dealii::Triangulation<2>::cell_iterator &cell,
                const std::array<double, 2>                   &position)
  {
    const dealii::Point<2> point(position[0], position[1]);
    for (const unsigned int v : cell->vertex_indices())
      if (point.distance(cell->vertex(v)) < 1e-6 * cell->diameter())
        return true;
    return cell->point_inside(point);
  }

  /// Whether a cell is within a distance of the load, or touches it at
  /// distance 0.
  /// @param half_length  of a line load along x through the impact point; 0
  ///                     around a point [m]
  bool
  is_near_load(const dealii::Triangulation<2>::cell_iterator &cell,
               double                                         half_length,
               double                                         distance = 0.);

  /// Sizes of the smallest and the largest active cell near the load. [m]
  std::pair<double, double>
  cell_sizes_near_load(const dealii::Triangulation<2> &mesh,
                       double                          half_length,
                       double                          distance = 0.);

  /// That of the smallest active cell. [m]
  inline double
  smallest_cell_size(const dealii::Triangulation<2> &mesh)
  {
    const double everywhere = std::numeric_limits<double>::infinity();
    return cell_sizes_near_load(mesh, 0., everywhere).first;
  }
} // namespace PlateImpact
