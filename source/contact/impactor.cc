#include "plate_impact/contact/impactor.h"

#include "plate_impact/base/parameters.h"

#include <cmath>

namespace PlateImpact
{
  Impactor
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
} // namespace PlateImpact
