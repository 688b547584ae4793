#ifndef plate_impact_analysis_delamination_h
#define plate_impact_analysis_delamination_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/contact/zener.h"

#include <optional>

namespace PlateImpact
{
  /// From which contact force on a laminate delaminates, by the energy that a
  /// round crack in its middle surface sets free however large it is:
  ///   P = pi sqrt(32 D* G_IIc / 3)
  /// (Davies & Zhang, Int. J. Impact Eng. 16, 1995, p. 149), with D* the mean
  /// bending stiffness (PlateSection). An impact whose peak comes before waves
  /// are back from an edge, one of a small mass, bears 1.213 of that (Olsson,
  /// Donadon & Falzon, Int. J. Solids Struct. 43, 2006, p. 3124).
  struct Delamination
  {
    double threshold; ///< [N]
    bool   is_of_small_mass;
  };

  /// @return empty for an isotropic plate, and where no toughness is given
  std::optional<Delamination>
  delamination(const Parameters   &parameters,
               const ZenerImpact  &expected,
               const ContactState &peak);
} // namespace PlateImpact

#endif
