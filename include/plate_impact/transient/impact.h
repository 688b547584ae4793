#ifndef plate_impact_transient_impact_h
#define plate_impact_transient_impact_h

#include "plate_impact/contact/contact_history.h"

#include <optional>

namespace PlateImpact
{
  /// A transient from first touch to the end time.
  struct Impact
  {
    ContactHistory        history;
    double                impulse         = 0.; ///< [N s]
    unsigned int          n_contact_steps = 0;  ///< with a force other than 0
    bool                  is_reduced      = false; ///< whether in Ritz vectors
    std::optional<double> separation_time;         ///< no contact since [s]
  };
} // namespace PlateImpact

#endif
