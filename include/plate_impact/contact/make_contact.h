#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/zener.h"

#include <cmath>
#include <optional>

namespace PlateImpact
{
  /// The impactor of a scene at first touch.
  inline Impactor
  make_impactor(const ImpactorParameters &parameters)
  {
    const double pi = std::acos(-1.), r = parameters.radius;
    const double volume = parameters.is_cylinder() ?
      pi * r * r * parameters.length :
      4. / 3. * pi * r * r * r;
    const double mass =
      parameters.mass > 0. ? parameters.mass : volume * parameters.density;
    return {mass, 0., parameters.velocity};
  }

  /// The contact of a scene at first touch. Its law is `line` (eq. 32), `Sun`
  /// (eq. 17 as printed, after Yang & Sun, NASA CR-165460, 1981) or `Hertz`
  /// (Johnson, Contact Mechanics, eq. 4.23), where the scene says so in series
  /// with the response of the layer and of the finite ball, and yielding.
  Contact
  make_contact(const Parameters &parameters);

  /// The same on another layer than the scene's.
  /// @param layer_constant  Lambda of LayerResponse; empty: a half-space
  Contact
  make_contact(const Parameters            &parameters,
               const std::optional<double> &layer_constant);

  /// The impact of a scene on an infinite thin plate, which needs no layer.
  inline ZenerImpact
  make_zener_impact(const Parameters &parameters)
  {
    return {make_contact(parameters, /*layer_constant=*/{}),
            make_impactor(parameters.impactor),
            PlateSection(parameters.plate)};
  }
} // namespace PlateImpact
