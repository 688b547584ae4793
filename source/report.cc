#include "plate_impact/report.h"

#include "plate_impact/version.h"

#include <iomanip>
#include <ostream>
#include <sstream>

namespace PlateImpact
{
  namespace
  {
    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        if (c == '&')
          result += "&amp;";
        else if (c == '<')
          result += "&lt;";
        else if (c == '>')
          result += "&gt;";
        else
          result += c;
      return result;
    }



    struct Column
    {
      std::string title, key;
      double      factor; ///< from SI units to those of the title
    };

    const std::vector<Column> columns = {
      {"Cycle", "cycle", 1.},
      {"Cells", "cells", 1.},
      {"Unknowns", "degrees_of_freedom", 1.},
      {"eta [%]", "discretization_error", 100.},
      {"max xi&#8242;", "max_element_error", 1.},
      {"Peak force [N]", "peak_force", 1.},
      {"at time [&#181;s]", "time_of_peak_force", 1e6},
      {"First contact ends [&#181;s]", "first_contact_end", 1e6},
      {"Impulse [N s]", "impulse", 1.},
      {"Impactor at the end [m/s]", "final_impactor_velocity", 1.},
      {"Energy drift", "relative_energy_drift", 1.}};



    void
    write_table(std::ostream &out, const nlohmann::ordered_json &cycles)
    {
      out << "<div class=\"wide\"><table><tr>";
      for (const Column &column : columns)
        if (cycles.back().contains(column.key))
          out << "<th>" << column.title << "</th>";
      out << "</tr>\n";
      for (const auto &cycle : cycles)
        {
          out << "<tr>";
          for (const Column &column : columns)
            if (cycles.back().contains(column.key))
              {
                out << "<td>";
                if (cycle.contains(column.key))
                  out << column.factor * cycle[column.key].get<double>();
                out << "</td>";
              }
          out << "</tr>\n";
        }
      out << "</table></div>\n";
    }
  } // namespace



  void
  write_report(std::ostream                   &out,
               const Scene                    &scene,
               const std::string              &outcome,
               const std::vector<std::string> &warnings,
               const nlohmann::ordered_json   &cycles,
               const std::vector<std::string> &pictures)
  {
    const auto &last = cycles.back();
    out << std::setprecision(6)
        << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
           "<meta name=\"viewport\" content=\"width=device-width\">"
           "<title>plate-impact: "
        << escaped(scene.name)
        << "</title><style>body{font-family:sans-serif;margin:2em auto;"
           "max-width:70em;padding:0 1em}table{border-collapse:collapse}"
           "td,th{border:1px solid #bbb;padding:.3em .6em;text-align:right}"
           ".wide{overflow-x:auto}.meshes{display:grid;gap:1em;"
           "grid-template-columns:repeat(auto-fit,minmax(20em,1fr))}"
           "svg{max-width:100%;height:auto}"
           "pre{background:#f4f4f4;color:#111;padding:1em;overflow-x:auto}"
           "</style></head><body>\n<h1>"
        << escaped(scene.name) << "</h1>\n<p>Outcome: <b>" << escaped(outcome)
        << "</b>";
    if (last.contains("peak_force"))
      out << ". Peak force: <b>" << last["peak_force"].get<double>()
          << " N</b> at " << 1e6 * last["time_of_peak_force"].get<double>()
          << " &#181;s";
    out << ".</p>\n";
    for (const std::string &warning : warnings)
      out << "<p><b>Warning:</b> " << escaped(warning) << "</p>\n";
    out << "<h2>Cycles</h2>\n";
    write_table(out, cycles);
    out << "<h2>Meshes</h2>\n<div class=\"meshes\">\n";
    for (const std::string &picture : pictures)
      out << picture;
    out << "</div>\n<h2>Scene</h2>\n<p>plate-impact " << PLATE_IMPACT_VERSION
        << "; save as a .prm file and give it to <code>plate-impact run</code> "
           "to repeat the run.</p>\n<pre>"
        << escaped(scene.text) << "</pre>\n</body></html>\n";
  }
} // namespace PlateImpact
