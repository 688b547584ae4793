#include "plate_impact/contact/impactor.h"

#include "plate_impact/base/entries.h"
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



  template <>
  const std::vector<Word<ImpactorShape>> Choices<ImpactorShape>::words = {
    {ImpactorShape::sphere, "sphere"},
    {ImpactorShape::cylinder, "cylinder"},
    {ImpactorShape::none, "none"}};



  void
  ImpactorParameters::declare_entries(Entries &entries)
  {
    const auto positive = number_above(0);
    const auto entry    = entries.section("Impactor");
    entry("Shape", "sphere", one_of<ImpactorShape>(), shape)
      .means("Cylinder: barrelled, with its axis along x.");
    entry("Radius", "0.01", positive, radius).means("[m]");
    entry("Length", "0.066667", positive, length)
      .means("Contact length 2l of a cylinder. [m]");
    entry("Mass", "0", number_from(0), mass)
      .means("0: from the density and the volume of the shape. [kg]");
    entry("Density", "7800", positive, density).means("[kg/m^3]");
    entry("Young's modulus", "2.1e11", positive, youngs_modulus).means("[Pa]");
    entry("Poisson's ratio", "0.3", number_between(-1, 0.5), poissons_ratio)
      .means("[-]");
    entry("Yield strength", "0", number_from(0), yield_strength)
      .means("As Plate/Yield strength. [Pa]");
    entry("Velocity", "1.0", positive, velocity)
      .means("Towards the plate. [m/s]");
  }
} // namespace PlateImpact
