#ifndef plate_impact_plate_support_h
#define plate_impact_plate_support_h

#include <deal.II/base/types.h>
#include <deal.II/fe/component_mask.h>

#include "plate_impact/base/parameters.h"

#include <map>


namespace PlateImpact
{
  /// What a support holds on an edge of the plate.
  struct Support
  {
    bool deflection;
    bool normal_rotation;     ///< theta_n, in the plane across the edge
    bool tangential_rotation; ///< theta_s, in the plane along the edge

    /// Components of the unknowns that it holds where the normal of the edge is
    /// x, or else y.
    dealii::ComponentMask
    held_components(bool normal_is_x) const;
  };


  const Support &
  find_support(EdgeSupport name);

  /// Those of the edges of a plate by their boundary ids.
  std::map<dealii::types::boundary_id, Support>
  supports_of(const PlateParameters &plate);

  /// What a plane of symmetry holds: it mirrors the plate.
  const Support &
  symmetry_plane();
} // namespace PlateImpact

#endif
