#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/command/commands.h"
#include "plate_impact/output/console.h"
#include "plate_impact/output/result_directory.h"
#include "plate_impact/sweep/sweep_computation.h"
#include "plate_impact/sweep/sweep_results.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    /// The lines of a scene without what may differ between a sweep and its
    /// continuation: comments and the name of the directory.
    std::vector<std::string>
    essence(std::istream &scene)
    {
      std::vector<std::string> lines;
      for (std::string line; std::getline(scene, line);)
        if (!line.empty() && line[0] != '#' &&
            line.find("set Directory ") == std::string::npos)
          lines.push_back(dealii::Utilities::trim(line));
      return lines;
    }



    /// @throws InputError when the directory holds a sweep of another scene
    void
    check_scene_to_resume(const ResultDirectory &directory,
                          const SweepScene      &scene)
    {
      std::ifstream      file(directory / "scene.prm");
      std::istringstream text(scene.text);
      if (!file)
        return;
      auto       before = essence(file);
      const auto now    = essence(text);
      before.resize(std::max(before.size(), now.size()));
      const auto [line, line_before] =
        std::mismatch(now.begin(), now.end(), before.begin());
      if (line != now.end())
        throw InputError({"--resume: " + (directory / "scene.prm").string() +
                          " belongs to another sweep: it has '" + *line_before +
                          "' where " + scene.name + " has '" + *line + "'"});
    }



    /// Sweeps up to this size have a line for every point.
    constexpr std::size_t most_lines = 40;

    /// More histories than these do not show in one plot.
    constexpr std::size_t most_plotted_histories = 12;

    /// A quantity in a line: its name in impact_quantities, and how it is
    /// shown.
    struct Column
    {
      const char *quantity, *title, *format;
      double      factor;
    };

    const Column shown_columns[] = {
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



    /// The first process' side of a sweep: what is written and printed.
    class SweepRecord
    {
    public:
      /// @param directory  cleared, or with the sweep to resume
      SweepRecord(SweepScene            &scene,
                  const ResultDirectory &directory,
                  const bool             resume,
                  const bool             quiet)
        : scene(scene)
        , console(quiet)
        , directory(directory)
        , table(directory, scene.plan, resume)
      {}

      std::vector<std::size_t>
      points_to_do() const
      {
        std::vector<std::size_t> points;
        for (std::size_t point = 0; point < table.rows.size(); ++point)
          if (!table.rows[point])
            points.push_back(point);
        return points;
      }

      /// @param n_groups  plates that the points share
      void
      begin(const std::size_t n_groups)
      {
        const SweepPlan &plan = scene.plan;
        n_points              = points_to_do().size();
        std::string text      = emphasized(scene.name, Emphasis::bold) + ": " +
          counted(plan.n_points, "point") + " of " + plan.names() + " on " +
          counted(n_groups, "plate");
        if (plan.may_adapt(scene.parameters))
          text += scene.parameters.sweep.adapts_each_point ?
            ", a mesh for each point" :
            ", each mesh adapted for its shortest contact";
        // of an interrupted sweep
        if (const std::size_t n_done = plan.n_points - n_points; n_done > 0)
          text += ", " + std::to_string(n_done) + " of them done before";
        text += '\n';
        if (n_points <= most_lines && n_points > 0)
          {
            for (const SweptEntry &entry : plan.entries)
              text += right(width_of(entry), entry.path);
            for (const Column &column : shown_columns)
              text += right(14, column.title);
            text += '\n';
          }
        console.print(text);
      }

      void
      add(SweepRow &&row)
      {
        // the table, which may have a million rows, is not to hold histories
        const ContactHistory history = std::exchange(row.history, {});
        if (!history.states().empty())
          {
            directory.write_file("contact_history_point_" +
                                   std::to_string(row.point + 1) + ".csv",
                                 [&](std::ostream &out) {
                                   history.write(out);
                                 });
            if (histories.size() < most_plotted_histories)
              histories[row.point] = history;
          }
        table.add(row);
        show(row);
      }

      void
      finish(const SweepWork &work)
      {
        for (const std::size_t point : points_to_do())
          add({point, {}, "not computed: its process ended early", {}, {}});
        table.finish();
        if (scene.parameters.output.write_report)
          directory.write_file("sweep.html", [&](std::ostream &out) {
            write_sweep_page(out, scene, table.rows, histories, work);
          });
        const double seconds = timer.wall_time();
        console.print("\nComputed    " + counted(n_computed, "point") + " in " +
                      about(seconds) + " s, " + about(n_computed / seconds) +
                      " points/s\nMade        " + counted(work.meshes, "mesh") +
                      ", " + counted(work.plates, "plate model") + ", " +
                      counted(work.loads, "response") +
                      " to a load\nResults     " + directory.main_files() +
                      '\n');
        const std::vector<std::string> warnings = sweep_warnings(table.rows);
        if (std::none_of(table.rows.begin(),
                         table.rows.end(),
                         [](const auto &row) { return row->failure.empty(); }))
          throw ComputationError(warnings.front());
        print_warnings(warnings);
      }

      /// What Ctrl-C leaves.
      std::string
      kept() const
      {
        return std::to_string(scene.plan.n_points - points_to_do().size()) +
          " of " + counted(scene.plan.n_points, "point") + " are in " +
          (directory / "sweep.csv").string() + "; --resume goes on from there";
      }

    private:
      /// A line per point of a small sweep; of a large one, on a terminal, the
      /// number of points done so far and the time that the others take.
      void
      show(const SweepRow &row)
      {
        ++n_computed;
        if (n_points > most_lines)
          return console.show(" ", n_computed, n_points);
        const std::vector<std::string> values = scene.plan.values(row.point);
        std::string                    text;
        for (std::size_t i = 0; i < values.size(); ++i)
          text += right(width_of(scene.plan.entries[i]), values[i]);
        if (!row.failure.empty())
          text += "  " + row.failure;
        else
          for (const Column &shown : shown_columns)
            for (std::size_t i = 0; i < impact_quantities.size(); ++i)
              if (impact_quantities[i].name == shown.quantity)
                text +=
                  column(14,
                         shown.format,
                         std::isnan(row.quantities[i]) ?
                           std::nullopt :
                           std::optional(shown.factor * row.quantities[i]));
        console.print(text + '\n');
      }

      SweepScene            &scene;
      Console                console;
      const ResultDirectory &directory;
      SweepTable             table;
      const dealii::Timer    timer;
      std::size_t n_points = 0, n_computed = 0; ///< without those before

      std::map<std::size_t, ContactHistory> histories; ///< for the page
    };



    /// Cleared for another sweep, or with the rows of the one to resume.
    void
    prepare(const ResultDirectory &directory,
            const SweepScene      &scene,
            const bool             resume)
    {
      if (resume)
        check_scene_to_resume(directory, scene);
      else
        directory.clear();
      directory.write_scene(scene.name, scene.text);
    }
  } // namespace



  void
  run_sweep(SweepScene &scene,
            const bool  resume,
            const bool  quiet,
            Processes  &processes)
  {
    // mpirun has its own way to end processes
    if (processes.size > 1)
      await_interrupt(/*ends_at_once=*/true);
    // the first process alone reads and writes results; without any it has
    // nothing to do for the others
    std::optional<ResultDirectory> directory;
    std::optional<SweepRecord>     record;
    std::vector<std::size_t>       to_do;
    std::exception_ptr             failure;
    if (processes.rank == 0)
      try
        {
          directory.emplace(scene.parameters.output.directory);
          prepare(*directory, scene, resume);
          record.emplace(scene, *directory, resume, quiet);
          to_do = record->points_to_do();
        }
      catch (...)
        {
          failure = std::current_exception();
        }
    processes.broadcast(to_do);
    if (failure)
      std::rethrow_exception(failure);

    const SweepGroups groups(scene.plan, scene.parameters);
    std::vector<bool> is_to_do(scene.plan.n_points, false);
    for (const std::size_t point : to_do)
      is_to_do[point] = true;
    // a few tasks for each process, so that all end at about the same time
    const std::size_t n_parts = processes.size == 1 ? 1 : 8 * processes.size;
    const auto        tasks =
      groups.tasks(is_to_do, std::max<std::size_t>(1, to_do.size() / n_parts));

    SweepComputation computation(scene, groups);
    const auto       take = [&record](SweepRow &&row) {
      record->add(std::move(row));
    };
    if (record)
      record->begin(groups.groups.size());
    try
      {
        const SweepWork work = processes.compute(tasks, computation, take);
        if (record)
          record->finish(work);
      }
    catch (const Interruption &interruption)
      {
        throw interruption.with(record->kept());
      }
  }
} // namespace PlateImpact
