#ifndef plate_impact_page_mesh_picture_h
#define plate_impact_page_mesh_picture_h

#include <deal.II/grid/tria.h>

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

  /// The same without caption and scale, for pages.
  /// @param label  for those who do not see it
  std::string
  mesh_picture(const dealii::Triangulation<2> &mesh,
               const std::string              &label,
               const std::vector<double>      &errors);
} // namespace PlateImpact

#endif
