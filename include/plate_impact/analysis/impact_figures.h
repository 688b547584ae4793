#ifndef plate_impact_analysis_impact_figures_h
#define plate_impact_analysis_impact_figures_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/transient/impactor_stepper.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// A quantity that an engineer reads from an impact.
  struct Figure
  {
    std::string name; ///< in sweep.csv
    std::string title;
    std::string unit; ///< empty: a pure number
  };


  /// Speed of the rebound over that of the impact; empty while the bodies touch
  /// or approach.
  std::optional<double>
  restitution(const ContactHistory &history);


  /// The figures of an impact, in the order of the columns of sweep.csv. SI
  /// units.
  const std::vector<Figure> &
  impact_figures();


  /// Their values; empty where an impact has none: an end of the contact that
  /// lasts to the end time, a restitution while bodies still touch or approach,
  /// Zener's numbers for a cylinder, their deviations after several contacts.
  ///
  /// @param expected              by Zener's equation
  /// @param discretization_error  eta, where it was estimated
  /// @param peak_force_bar        as PeakForceBar::total(), where there is one
  std::vector<std::optional<double>>
  values_of_figures(const Impact                &impact,
                    const Parameters            &parameters,
                    const ExpectedPeak          &expected,
                    const std::optional<double> &discretization_error,
                    const std::optional<double> &peak_force_bar);
} // namespace PlateImpact

#endif
