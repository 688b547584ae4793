#ifndef plate_impact_page_mesh_picture_h
#define plate_impact_page_mesh_picture_h

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"

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

  /// The same without caption and scale, for pages, with the load patch and
  /// what the scripts need to show it alone: data-unit, the length of a metre,
  /// and data-x, -y, -r of the patch.
  /// @param label  for those who do not see it
  std::string
  mesh_picture(const dealii::Triangulation<2> &mesh,
               const Parameters               &parameters,
               const std::string              &label,
               const std::vector<double>      &errors);

  /// Which part of the plate the meshes of a scene are, and where the impact
  /// is.
  std::string
  meshed_part_in_words(const PlateParameters &plate);
} // namespace PlateImpact

#endif
