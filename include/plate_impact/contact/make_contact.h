#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/zener.h"

#include <optional>

namespace PlateImpact
{
  /// The contact of a scene at first touch. Its law is `line` (eq. 32), `Sun`
  /// (eq. 17 as printed: 1/E for the plate, after Yang & Sun, NASA CR-165460,
  /// 1981) or `Hertz` ((1 - nu^2)/E for both bodies, Johnson, Contact
  /// Mechanics, eq. 4.23), in series with the local response of the layer that
  /// the plate is, and of the finite ball, where the scene says so. A sphere
  /// yields where the scene gives a yield strength of it or of the plate.
  Contact
  make_contact(const Parameters &parameters);

  /// The same on another layer than the scene's.
  /// @param layer_constant  Lambda of LayerResponse; empty: a half-space
  Contact
  make_contact(const Parameters            &parameters,
               const std::optional<double> &layer_constant);

  /// The impact of a scene on an infinite plate. Its contact is that without
  /// the layer: a point load on a thin plate, which has no thickness, needs
  /// none.
  ZenerImpact
  make_zener_impact(const Parameters &parameters);
} // namespace PlateImpact
