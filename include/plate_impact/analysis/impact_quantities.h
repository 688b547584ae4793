#ifndef plate_impact_analysis_impact_quantities_h
#define plate_impact_analysis_impact_quantities_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_bodies.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/contact/zener.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// An impact that has been computed, with what its quantities come from.
  struct ComputedImpact
  {
    const Parameters     &parameters;
    const ZenerImpact    &expected;
    const ContactHistory &history;
    double                impulse;                   ///< [N s]
    std::optional<double> discretization_error = {}; ///< eta
    std::optional<double> peak_force_bar       = {}; ///< PeakForceBar::total()
    const ContactBodies   bodies{parameters, expected.section};
  };


  /// A quantity that an engineer reads from an impact.
  struct ImpactQuantity
  {
    std::string name; ///< in summary.json and sweep.csv
    std::string title;
    std::string unit; ///< of SI; empty: a pure number

    /// Empty where an impact has none: an end of the contact that lasts to the
    /// end time, a restitution while bodies still touch or approach, Zener's
    /// numbers for a cylinder, their deviations after several contacts.
    std::optional<double> (*value)(const ComputedImpact &impact);
  };


  /// All of them, in the order of the columns of sweep.csv.
  const std::vector<ImpactQuantity> &
  impact_quantities();
} // namespace PlateImpact

#endif
