#ifndef plate_impact_support_h
#define plate_impact_support_h

#include <deal.II/fe/component_mask.h>

#include <string>
#include <vector>

namespace PlateImpact
{
  /// What a support holds on an edge of the plate.
  struct Support
  {
    std::string name;
    bool        deflection;
    bool        normal_rotation;     ///< theta_n, in the plane across the edge
    bool        tangential_rotation; ///< theta_s, in the plane along the edge

    /// Components of the unknowns that it holds where the normal of the edge is
    /// x, or else y.
    dealii::ComponentMask
    held_components(bool normal_is_x) const;
  };


  /// What Plate/Support may name.
  std::vector<std::string>
  support_names();

  /// @throws std::logic_error for a name that is not in support_names()
  const Support &
  find_support(const std::string &name);

  /// What a plane of symmetry holds: it mirrors the plate.
  const Support &
  symmetry_plane();
} // namespace PlateImpact

#endif
