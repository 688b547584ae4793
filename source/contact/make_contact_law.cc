#include "plate_impact/contact/make_contact_law.h"

#include "plate_impact/contact/yang_sun_law.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/plate_section.h"

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// k of Hertz's law for the compliance that the scene's law has for the
    /// plate.
    double
    coefficient_of(const Parameters &parameters)
    {
      const PlateSection        section(parameters.plate);
      const ImpactorParameters &impactor = parameters.impactor;
      return hertz_coefficient(
        impactor.radius,
        (1. - impactor.poissons_ratio * impactor.poissons_ratio) /
          impactor.youngs_modulus,
        parameters.contact.law == ForceLaw::Sun ?
          1. / section.contact_modulus :
          section.half_space_compliance);
    }



    /// The constant beside ln(l/a) of a line contact on a layer: the plate's
    /// side of the approach is F' (1 - nu) / (pi G) (ln(h/a) + Lambda), the
    /// cylinder's F' (1 - nu^2) / (pi E) (2 ln(4r/a) - 1), to its axis
    /// (Johnson, sec. 5.6), F' the force per length.
    double
    line_constant_of_layer(const Parameters &parameters, const double Lambda)
    {
      const PlateParameters    &plate    = parameters.plate;
      const ImpactorParameters &impactor = parameters.impactor;
      const double              nu_i     = impactor.poissons_ratio;
      return contact_modulus(parameters) *
        (PlateSection(plate).half_space_compliance *
           (std::log(plate.thickness) + Lambda) +
         (1. - nu_i * nu_i) / impactor.youngs_modulus *
           (std::log(4. * impactor.radius) - 0.5)) -
        std::log(0.5 * impactor.length);
    }
  } // namespace



  std::unique_ptr<const ContactLaw>
  make_half_space_law(const Parameters &parameters)
  {
    const ImpactorParameters &impactor = parameters.impactor;
    if (parameters.contact.law == ForceLaw::line)
      return std::make_unique<LineLaw>(impactor.radius,
                                       0.5 * impactor.length,
                                       contact_modulus(parameters));
    return std::make_unique<HertzLaw>(coefficient_of(parameters));
  }



  double
  layer_constant(const PlateParameters &plate, const ContactParameters &contact)
  {
    if (contact.local_response == LocalResponse::half_space)
      return 0.;
    const LayerResponse layer(plate, contact.load_distribution);
    const double        radius = contact.patch_radius / plate.thickness;
    return contact.law == ForceLaw::line ? layer.line_constant(radius) :
                                           layer.sphere_constant(radius);
  }



  std::unique_ptr<const ContactLaw>
  make_contact_law(const Parameters &parameters)
  {
    return make_contact_law(parameters,
                            layer_constant(parameters.plate,
                                           parameters.contact));
  }



  std::unique_ptr<const ContactLaw>
  make_contact_law(const Parameters &parameters, const double layer_constant)
  {
    const ImpactorParameters &impactor = parameters.impactor;
    if (parameters.contact.unloading == UnloadingLaw::Yang_Sun)
      return std::make_unique<YangSunLaw>(
        coefficient_of(parameters),
        parameters.contact.critical_indentation);
    if (parameters.contact.local_response == LocalResponse::half_space)
      return make_half_space_law(parameters);
    if (parameters.contact.law == ForceLaw::line)
      return std::make_unique<LineLaw>(impactor.radius,
                                       0.5 * impactor.length,
                                       contact_modulus(parameters),
                                       line_constant_of_layer(parameters,
                                                              layer_constant));
    return std::make_unique<SeriesLaw>(
      coefficient_of(parameters),
      layer_constant /
        (PlateSection(parameters.plate).shear_modulus *
         parameters.plate.thickness));
  }
} // namespace PlateImpact
