#include "plate_impact/impactor.h"

#include "plate_impact/parameters.h"

#include <cmath>

namespace PlateImpact
{
  Impactor
  make_impactor(const ImpactorParameters &parameters)
  {
    const double r    = parameters.radius;
    const double mass = parameters.mass > 0.
      ? parameters.mass
      : 4. / 3. * std::acos(-1.) * r * r * r * parameters.density;
    return {mass, 0., parameters.velocity};
  }
} // namespace PlateImpact
