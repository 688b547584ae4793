#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace PlateImpact
{
  struct Arc
  {
    dealii::Point<2> centre;
    double           radius;
  };

  /// Finds sides of one edge that are chords of a circle, nine or more to a
  /// full turn, and makes them parts of arcs: their manifold id is the number
  /// of an arc, and that manifold is set.
  /// @param mesh  of one level, with boundary ids
  std::vector<Arc>
  find_arcs(dealii::Triangulation<2> &mesh);
} // namespace PlateImpact
