#include "plate_impact/analysis/delamination.h"

#include "plate_impact/plate/plate_geometry.h"

#include <cmath>

namespace PlateImpact
{
  std::optional<Delamination>
  delamination(const Parameters   &parameters,
               const ZenerImpact  &expected,
               const ContactState &peak)
  {
    const PlateParameters &plate = parameters.plate;
    if (!plate.is_laminate() || plate.ply.mode_2_toughness == 0. ||
        peak.force <= 0.)
      return {};
    const double slow = std::acos(-1.) *
      std::sqrt(32. / 3. * expected.section.mean_bending_stiffness() *
                plate.ply.mode_2_toughness);
    const double there_and_back = 2. * geometry_of(plate)->distance_to_edge() /
      expected.wave_of(2. * peak.time).group_speed;
    const bool is_of_small_mass = peak.time < there_and_back;
    return Delamination{is_of_small_mass ? 1.213 * slow : slow,
                        is_of_small_mass};
  }
} // namespace PlateImpact
