#ifndef plate_impact_adaptation_make_mesh_adaptation_h
#define plate_impact_adaptation_make_mesh_adaptation_h

#include "plate_impact/adaptation/mesh_adaptation.h"

#include <memory>

namespace PlateImpact
{
  /// The strategy that the scene names; `none` keeps the mesh.
  /// @param contact_half_length  l of a contact along 0 <= x <= l; 0 for a
  ///                             sphere [m]
  std::unique_ptr<const MeshAdaptation>
  make_mesh_adaptation(const AdaptivityParameters &adaptivity,
                       double                      contact_half_length = 0.);
} // namespace PlateImpact

#endif
