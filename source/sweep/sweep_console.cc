#include "plate_impact/sweep/sweep_console.h"

#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/base/text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    /// Sweeps up to this size have a line for every point.
    constexpr std::size_t most_lines = 40;

    /// A figure in a line: its name in impact_quantities(), and how it is
    /// shown.
    struct Column
    {
      const char *figure, *title, *format;
      double      factor;
    };

    const Column columns[] = {
      {"peak_force", "peak force N", "{:.6g}", 1.},
      {"time_of_peak_force", "at us", "{:.4g}", 1e6},
      {"first_contact_end", "contact end", "{:.5g}", 1e6},
      {"number_of_contacts", "contacts", "{:.0f}", 1.},
      {"coefficient_of_restitution", "restitution", "{:.4f}", 1.}};



    std::size_t
    width_of(const SweptEntry &entry)
    {
      std::size_t width = entry.path.size();
      for (const std::string &value : entry.values)
        width = std::max(width, value.size());
      return width + 2;
    }
  } // namespace



  SweepConsole::SweepConsole(const SweepScene &scene, const bool quiet)
    : scene(scene)
    , console(quiet)
  {}



  void
  SweepConsole::begin(const std::size_t n_groups, const std::size_t n_done)
  {
    const SweepPlan &plan = scene.plan();
    n_points              = plan.n_points() - n_done;
    std::string names;
    for (const SweptEntry &entry : plan.entries())
      names += (names.empty() ? "" : ", ") + entry.path;
    std::string text = emphasized(scene.name(), Emphasis::bold) + ": " +
      counted(plan.n_points(), "point") + " of " + names + " on " +
      counted(n_groups, "plate");
    if (scene.may_adapt())
      text += scene.parameters().sweep.adapt == SweepAdaptation::each_point ?
        ", a mesh for each point" :
        ", each mesh adapted for its shortest contact";
    if (n_done > 0)
      text += ", " + std::to_string(n_done) + " of them done before";
    text += '\n';
    if (n_points <= most_lines && n_points > 0)
      {
        for (const SweptEntry &entry : plan.entries())
          text += right(width_of(entry), entry.path);
        for (const Column &column : columns)
          text += right(14, column.title);
        text += '\n';
      }
    console.print(text);
  }



  void
  SweepConsole::row(const SweepRow &row)
  {
    ++n_computed;
    if (n_points > most_lines)
      return console.show(" ", n_computed, n_points);
    const SweepPlan               &plan   = scene.plan();
    const std::vector<std::string> values = plan.values(row.point);
    std::string                    text;
    for (std::size_t i = 0; i < values.size(); ++i)
      text += right(width_of(plan.entries()[i]), values[i]);
    if (!row.failure.empty())
      text += "  " + row.failure;
    else
      for (const Column &shown : columns)
        for (std::size_t i = 0; i < impact_quantities().size(); ++i)
          if (impact_quantities()[i].name == shown.figure)
            text += column(14,
                           shown.format,
                           std::isnan(row.figures[i]) ?
                             std::nullopt :
                             std::optional(shown.factor * row.figures[i]));
    console.print(text + '\n');
  }



  void
  SweepConsole::end(const SweepWork &work, const std::string &results)
  {
    const std::chrono::duration<double> elapsed =
      std::chrono::steady_clock::now() - start;
    console.print("\nComputed    " + counted(n_computed, "point") + " in " +
                  about(elapsed.count()) + " s, " +
                  about(n_computed / elapsed.count()) +
                  " points/s\nMade        " + counted(work.meshes, "mesh") +
                  ", " + counted(work.plates, "plate model") + ", " +
                  counted(work.loads, "response") + " to a load\nResults     " +
                  results + '\n');
  }
} // namespace PlateImpact
