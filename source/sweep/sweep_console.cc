#include "plate_impact/sweep/sweep_console.h"

#include "plate_impact/analysis/impact_figures.h"
#include "plate_impact/base/text.h"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <unistd.h>

namespace PlateImpact
{
  namespace
  {
    /// Sweeps up to this size have a line for every point.
    constexpr std::size_t most_lines = 40;

    /// A figure in a line: its name in impact_figures(), and how it is shown.
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



  SweepConsole::SweepConsole(const bool quiet)
    : quiet(quiet)
    , out(STDOUT_FILENO)
    // mpirun makes its processes' output a terminal where it has none itself,
    // but not their input
    , shows_progress(!quiet && out.is_interactive() && isatty(STDIN_FILENO))
    , start(std::chrono::steady_clock::now())
    , last_progress(start)
  {
    std::signal(SIGPIPE, SIG_IGN);
  }



  void
  SweepConsole::begin(const SweepScene &scene,
                      const std::size_t n_groups,
                      const std::size_t n_done)
  {
    plan     = scene.plan();
    n_points = plan->n_points() - n_done;
    if (quiet)
      return;
    std::string names;
    for (const SweptEntry &entry : plan->entries())
      names += (names.empty() ? "" : ", ") + entry.path;
    std::cout << out.emphasized(scene.name(), Emphasis::bold) << ": "
              << counted(plan->n_points(), "point") << " of " << names << " on "
              << counted(n_groups, "plate");
    if (scene.may_adapt())
      std::cout << (scene.parameters().sweep.adapt ==
                        SweepAdaptation::each_point ?
                      ", a mesh for each point" :
                      ", each mesh adapted for its shortest contact");
    if (n_done > 0)
      std::cout << ", " << n_done << " of them done before";
    std::cout << '\n';
    if (n_points > most_lines || n_points == 0)
      return;
    for (const SweptEntry &entry : plan->entries())
      std::cout << right(width_of(entry), entry.path);
    for (const Column &column : columns)
      std::cout << right(14, column.title);
    std::cout << std::endl;
  }



  void
  SweepConsole::row(const SweepRow &row)
  {
    ++n_computed;
    if (quiet)
      return;
    if (n_points > most_lines)
      {
        const auto now = std::chrono::steady_clock::now();
        if (!shows_progress ||
            (has_progress &&
             now - last_progress < std::chrono::milliseconds(500)))
          return;
        last_progress                               = now;
        has_progress                                = true;
        const std::chrono::duration<double> elapsed = now - start;
        std::cout << "\r\033[K " << n_computed << " of " << n_points << ", "
                  << waiting_time(elapsed.count() * (n_points - n_computed) /
                                  n_computed)
                  << " left" << std::flush;
        return;
      }
    const std::vector<std::string> values = plan->values(row.point);
    for (std::size_t i = 0; i < values.size(); ++i)
      std::cout << right(width_of(plan->entries()[i]), values[i]);
    if (!row.failure.empty())
      std::cout << "  " << row.failure;
    else
      for (const Column &shown : columns)
        for (std::size_t i = 0; i < impact_figures().size(); ++i)
          if (impact_figures()[i].name == shown.figure)
            {
              std::optional<double> value = row.figures[i];
              if (value)
                *value *= shown.factor;
              std::cout << column(14, shown.format, value);
            }
    std::cout << std::endl;
  }



  void
  SweepConsole::end(const SweepWork                &work,
                    const std::vector<std::string> &warnings,
                    const std::string              &results)
  {
    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
        .count();
    if (!quiet)
      {
        if (has_progress)
          std::cout << "\r\033[K";
        std::cout << "\nComputed    " << counted(n_computed, "point") << " in "
                  << about(seconds) << " s, " << about(n_computed / seconds)
                  << " points/s"
                  << "\nMade        " << counted(work.meshes, "mesh") << ", "
                  << counted(work.plates, "plate model") << ", "
                  << counted(work.loads, "response") << " to a load"
                  << "\nResults     " << results << std::endl;
      }
    print_warnings(warnings);
  }
} // namespace PlateImpact
