#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/plate/plate_geometry.h"

#include <vector>

namespace PlateImpact
{
  /// The strength lambda of the singularity at a corner of a Reissner-Mindlin
  /// plate: near it the moments grow as r^{lambda - 1}, or the shear forces do
  /// where these grow faster. The rotations behave as the displacements of
  /// plane stress in a wedge whose sides are held (clamped), free (free and
  /// soft simply supported) or on rollers (simply supported); the deflection as
  /// that of a membrane (Williams, J. Appl. Mech. 19, 1952, p. 526;
  /// Burton & Sinclair, J. Appl. Mech. 53, 1986, p. 220).
  /// @param angle           between the two edges, inside the plate [rad]
  /// @param supports        of the two edges
  /// @param poissons_ratio  of the plate
  /// @return the smallest real part of an exponent between 0 and 1; 1 where
  ///         there is no singularity [-]
  double
  corner_strength(double                            angle,
                  const std::array<EdgeSupport, 2> &supports,
                  double                            poissons_ratio);

  /// The singular points that the mesh of a scene has, with the impact at the
  /// origin: those that the scene names or else, for the goal energy norm, the
  /// corners and changes of support of the outline, the ends of a line load and
  /// a point load. Corners of less than ten degrees between edges with one
  /// support are taken for a bend of a smooth edge. A laminate's exponents are
  /// those of an isotropic plate with a Poisson's ratio of 0.3.
  std::vector<SingularPoint>
  singular_points(const Parameters &parameters);
} // namespace PlateImpact
