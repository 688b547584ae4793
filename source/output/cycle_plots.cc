#include "plate_impact/output/cycle_plots.h"

#include "plate_impact/base/text.h"

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    using Json = nlohmann::ordered_json;



    /// A quantity of the table of cycles.
    struct Quantity
    {
      std::string name, key, unit; ///< unit of SI; "%" for fractions
    };

    const std::vector<Quantity> quantities = {
      {"Cells", "cells", ""},
      {"Unknowns", "degrees_of_freedom", ""},
      {"Smallest cell", "min_cell_size", "m"},
      {"η", "discretization_error", "%"},
      {"largest ξ′", "max_element_error", ""},
      {"Cells with ξ′ ≥ 1", "cells_above_limit", ""},
      {"Peak force", "peak_force", "N"},
      {"Error bar of the peak force", "peak_force_error_bar", "%"},
      {"at", "time_of_peak_force", "s"},
      {"First contact ends", "first_contact_end", "s"},
      {"Contacts", "number_of_contacts", ""},
      {"Impulse", "impulse", "N s"},
      {"Impactor at the end", "final_impactor_velocity", "m/s"},
      {"Largest displacement", "max_plate_displacement", "m"},
      {"Largest stress of the plate", "max_effective_stress", "Pa"},
      {"Energy drift", "relative_energy_drift", ""}};



    /// What a quantity is over the cycles; NaN where a cycle does not have it.
    std::vector<double>
    over_cycles(const Json &cycles, const std::string &key)
    {
      std::vector<double> values;
      for (const Json &cycle : cycles)
        values.push_back(cycle.contains(key) ? cycle[key].get<double>() :
                                               std::nan(""));
      return values;
    }
  } // namespace



  Table
  table_of_cycles(const Json &cycles)
  {
    Table table;
    table.columns.push_back("Cycle");
    for (const Json &cycle : cycles)
      table.columns.push_back(std::to_string(cycle["cycle"].get<int>()));
    for (const Quantity &quantity : quantities)
      {
        if (!cycles.back().contains(quantity.key))
          continue;
        std::vector<double> values = over_cycles(cycles, quantity.key);
        std::string         unit   = quantity.unit;
        if (unit == "%")
          for (double &value : values)
            value *= 100.;
        else if (!unit.empty())
          {
            const PrefixedUnit prefixed(unit, values);
            unit   = prefixed.name();
            values = prefixed(values);
          }
        table.rows.push_back({with_unit(quantity.name, unit)});
        // whole numbers, and what is compared from cycle to cycle
        for (const double value : values)
          table.rows.back().push_back(quantity.key == "peak_force" ||
                                          value == std::round(value) ?
                                        number(value) :
                                        rounded(value));
      }
    return table;
  }



  Plot
  plot_over_cycles(const Json        &cycles,
                   const std::string &key,
                   const Axis        &y,
                   const double       factor)
  {
    std::vector<double> values = over_cycles(cycles, key);
    for (double &value : values)
      value *= factor;
    const std::string title = y.title.substr(0, y.title.find(" ["));
    return {title,
            "",
            {"cycle"},
            y,
            {{title,
              over_cycles(cycles, "cycle"),
              values,
              0,
              Style::line_and_points}},
            {}};
  }



  Plot
  errors_against_seconds(const Json &cycles)
  {
    const std::vector<double> seconds =
      over_cycles(cycles, "cumulative_seconds");
    const auto in_percent = [&](const std::string &key) {
      std::vector<double> values = over_cycles(cycles, key);
      for (double &value : values)
        value *= 100.;
      return values;
    };
    const std::vector<double> eta = in_percent("discretization_error");
    return {"Error against time",
            "The slope is that of an error that halves when the time doubles.",
            {"seconds since the beginning", true},
            {"error [%]", true},
            {{"η", seconds, eta, 0, Style::line_and_points},
             {"error bar of the peak force",
              seconds,
              in_percent("peak_force_error_bar"),
              1,
              Style::line_and_points},
             {"slope −1",
              {seconds.front(), seconds.back()},
              {eta.front(), eta.front() * seconds.front() / seconds.back()},
              2,
              Style::dashed}},
            {}};
  }



  Plot
  seconds_by_stage(const Json &cycles)
  {
    Plot plot{"Time by stage",
              "",
              {"wall time [s]", false},
              {"cycle", false},
              {},
              {}};
    for (const Json &cycle : cycles)
      plot.categories.push_back(std::to_string(cycle["cycle"].get<int>()));
    for (const auto &[stage, seconds] : cycles.back()["seconds"].items())
      {
        if (stage == "total")
          continue;
        std::vector<double> values;
        for (const Json &cycle : cycles)
          values.push_back(cycle["seconds"][stage].get<double>());
        plot.series.push_back(
          {stage, {}, values, unsigned(plot.series.size())});
      }
    return plot;
  }
} // namespace PlateImpact
