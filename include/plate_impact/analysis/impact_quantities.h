#ifndef plate_impact_analysis_impact_quantities_h
#define plate_impact_analysis_impact_quantities_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/transient/impactor_stepper.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// A quantity that an engineer reads from an impact.
  struct ImpactQuantity
  {
    std::string name; ///< in sweep.csv
    std::string title;
    std::string unit; ///< empty: a pure number
  };


  /// Speed of the rebound over that of the impact; empty while the bodies touch
  /// or approach.
  std::optional<double>
  restitution(const ContactHistory &history);


  /// The quantities of an impact, in the order of the columns of sweep.csv. SI
  /// units.
  const std::vector<ImpactQuantity> &
  impact_quantities();


  /// Their values; empty where an impact has none: an end of the contact that
  /// lasts to the end time, a restitution while bodies still touch or approach,
  /// Zener's numbers for a cylinder, their deviations after several contacts.
  ///
  /// @param expected              by Zener's equation
  /// @param discretization_error  eta, where it was estimated
  /// @param peak_force_bar        as PeakForceBar::total(), where there is one
  std::vector<std::optional<double>>
  values_of_quantities(const Impact                &impact,
                       const Parameters            &parameters,
                       const ExpectedPeak          &expected,
                       const std::optional<double> &discretization_error,
                       const std::optional<double> &peak_force_bar);
} // namespace PlateImpact

#endif
