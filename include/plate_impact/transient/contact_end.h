#ifndef plate_impact_transient_contact_end_h
#define plate_impact_transient_contact_end_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/transient/plate_model.h"

namespace PlateImpact
{
  /// The scene with an end time: its own or, where that is 0, the end of the
  /// first contact on this plate. It ends by the time that an impactor takes to
  /// be thrown back by a massless plate and the contact, twice over; beyond it,
  /// or 2^18 steps, nobody waits.
  /// @param needs_states  as for PlateModel::under()
  /// @throws ComputationError naming step and quantity
  Parameters
  until_contact_ends(PlateModel       &plate,
                     const Parameters &impact,
                     bool              needs_states);
} // namespace PlateImpact

#endif
