#ifndef plate_impact_contact_make_contact_law_h
#define plate_impact_contact_make_contact_law_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_law.h"

#include <memory>

namespace PlateImpact
{
  /// The law that the scene names: `line` (eq. 32), `Sun` (eq. 17 as printed:
  /// 1/E for the plate, after Yang & Sun, NASA CR-165460, 1981) or `Hertz` ((1
  /// - nu^2)/E for both bodies, Johnson, Contact Mechanics, eq. 4.23), with the
  /// local response of the layer that the plate is where the scene says so.
  std::unique_ptr<const ContactLaw>
  make_contact_law(const Parameters &parameters);

  /// The same where what it takes from the layer is known.
  /// @param layer_constant  that of the function below
  std::unique_ptr<const ContactLaw>
  make_contact_law(const Parameters &parameters, double layer_constant);

  /// Lambda of the layer under a sphere or a line contact, which no impactor
  /// changes; 0 for a half-space.
  double
  layer_constant(const PlateParameters   &plate,
                 const ContactParameters &contact);

  /// The law without the layer, for Zener's equation: the point load on a thin
  /// plate, which has no thickness, needs none.
  std::unique_ptr<const ContactLaw>
  make_half_space_law(const Parameters &parameters);
} // namespace PlateImpact

#endif
