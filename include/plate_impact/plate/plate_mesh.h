#ifndef plate_impact_plate_plate_mesh_h
#define plate_impact_plate_plate_mesh_h

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"

#include <memory>

namespace PlateImpact
{
  /// Boundary ids of the quadrant 0 <= x <= a/2, 0 <= y <= b/2 with the impact
  /// at the origin.
  enum PlateBoundary : dealii::types::boundary_id
  {
    symmetry_x = 0, ///< x = 0
    edge_x     = 1, ///< x = a/2
    symmetry_y = 2, ///< y = 0
    edge_y     = 3  ///< y = b/2
  };

  /// The quadrant in equal rectangular cells. Refinement keeps neighbours,
  /// across vertices too, within one level of each other: patches of the stress
  /// recovery then mix cells of similar size only.
  std::unique_ptr<dealii::Triangulation<2>>
  make_plate_quadrant(const PlateParameters             &plate,
                      const std::array<unsigned int, 2> &n_cells);

  std::unique_ptr<dealii::Triangulation<2>>
  copy_of(const dealii::Triangulation<2> &mesh);

  /// Size h of a cell: its longest side, which is what resolves a field. [m]
  double
  cell_size(const dealii::Triangulation<2>::cell_iterator &cell);

  /// That of the smallest active cell. [m]
  double
  smallest_cell_size(const dealii::Triangulation<2> &mesh);
} // namespace PlateImpact

#endif
