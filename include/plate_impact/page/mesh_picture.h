#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/page/page.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// A mesh that begins at the origin with its cells coloured by xi' and a
  /// scale, as SVG.
  /// @param caption  stands above
  /// @param errors   xi' by active index; empty where they are not known
  void
  write_mesh_svg(std::ostream                   &out,
                 const dealii::Triangulation<2> &mesh,
                 const std::string              &caption,
                 const std::vector<double>      &errors);

  /// A mesh for a page: `title`, `vertices` (x and y of each [m]), `cells`
  /// (four vertices of each, lexicographic), and `fields`, with xi' as the
  /// first where it is known.
  Json
  mesh_on_page(const dealii::Triangulation<2> &mesh,
               const std::string              &title,
               const std::vector<double>      &errors);

  /// What pictures of meshes need of a scene: `patch`, the load around the
  /// origin, with its `radius` [m], 0 without one, and `isDisc`; `symmetric`,
  /// whether the plate mirrors in x = 0 and y = 0.
  Json
  plate_on_page(const Parameters &parameters);
} // namespace PlateImpact
