#pragma once

#include <deal.II/base/point.h>

#include "plate_impact/base/parameters.h"

#include <limits>
#include <vector>

namespace PlateImpact
{
  /// A point of the plate, from the impact, and the fraction of the force that
  /// acts there and at its mirror images.
  struct LoadPoint
  {
    dealii::Point<2> point;
    double           weight;
  };

  /// Quadrature of the scene's load distribution over the quadrant x >= 0, y >=
  /// 0, with several points in each cell there; the weights sum to one.
  /// `point`: the origin. `Hertz disc`: pressure ~ sqrt(1 - (r/c)^2), `uniform
  /// disc`: constant pressure, both within the patch radius c. `line`: constant
  /// force along the contact length of a cylinder, along x; `strip`: the same
  /// with pressure ~ sqrt(1 - (y/c)^2) across.
  /// @param length       of the contact of a cylinder, 2l [m]
  /// @param finest_cell  size of the smallest that the load falls on [m]
  std::vector<LoadPoint>
  make_load_distribution(
    const ContactParameters &contact,
    double                   length,
    double finest_cell = std::numeric_limits<double>::infinity());

  /// The same on what is meshed of a plate: points of the quadrant are joined
  /// by their mirror images in axes that are no planes of symmetry.
  std::vector<LoadPoint>
  on_meshed_part(std::vector<LoadPoint> of_quadrant,
                 const PlateParameters &plate);
} // namespace PlateImpact
