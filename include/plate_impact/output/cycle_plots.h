#ifndef plate_impact_output_cycle_plots_h
#define plate_impact_output_cycle_plots_h

#include "plate_impact/page/page.h"

#include <nlohmann/json.hpp>

#include <string>

namespace PlateImpact
{
  /// What cycles as in summary.json look like on a page. Quantities that the
  /// last cycle does not have are left out.
  /// @{

  /// All quantities, a row each with its unit, a column per cycle: few cycles
  /// beside each other fit any screen.
  Table
  table_of_cycles(const nlohmann::ordered_json &cycles);

  /// One quantity over the cycles.
  /// @param key     of the quantity in summary.json
  /// @param y       with the unit of values times `factor`
  Plot
  plot_over_cycles(const nlohmann::ordered_json &cycles,
                   const std::string            &key,
                   const Axis                   &y,
                   double                        factor = 1.);

  /// eta and the error bar of the peak force against the time since the
  /// beginning, with the slope of errors that halve when the time doubles.
  Plot
  errors_against_seconds(const nlohmann::ordered_json &cycles);

  /// Wall time as stacked bars, one per cycle.
  Plot
  seconds_by_stage(const nlohmann::ordered_json &cycles);

  /// @}
} // namespace PlateImpact

#endif
