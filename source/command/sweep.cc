#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/command/commands.h"
#include "plate_impact/output/console.h"
#include "plate_impact/output/result_directory.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <exception>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    /// The next line of a scene, empty at its end, without what may differ
    /// between a sweep and its continuation: comments and the name of the
    /// directory.
    std::string
    next_line(std::istream &scene)
    {
      for (std::string line; std::getline(scene >> std::ws, line);)
        if (line[0] != '#' && line.find("set Directory ") == std::string::npos)
          return dealii::Utilities::trim(line);
      return {};
    }



    /// @throws InputError when the directory holds a sweep of another scene
    void
    check_scene_to_resume(const ResultDirectory &directory,
                          const SweepScene      &scene)
    {
      std::ifstream file(directory / "scene.prm");
      if (!file)
        return;
      std::istringstream text(scene.text);
      for (std::string now; !(now = next_line(text)).empty();)
        if (const std::string before = next_line(file); before != now)
          throw InputError({"--resume: " + (directory / "scene.prm").string() +
                            " belongs to another sweep: it has '" + before +
                            "' where " + scene.name + " has '" + now + "'"});
    }



    const std::string file_name = "sweep.csv";
    const std::string separator = " | "; ///< of warnings



    /// A field of a table, in quotes where it needs them (RFC 4180).
    std::string
    as_field(const std::string &text)
    {
      if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
      return '"' + dealii::Utilities::replace_in_string(text, "\"", "\"\"") +
        '"';
    }



    std::vector<std::string>
    split(const std::string &line)
    {
      std::vector<std::string> fields(1);
      bool                     is_quoted = false;
      for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '"' && is_quoted && line[i + 1] == '"')
          fields.back() += line[++i]; // of two within quotes
        else if (line[i] == '"')
          is_quoted = !is_quoted;
        else if (line[i] == ',' && !is_quoted)
          fields.emplace_back();
        else
          fields.back() += line[i];
      return fields;
    }



    std::string
    joined(const std::vector<std::string> &values)
    {
      std::string text;
      for (const std::string &value : values)
        text += as_field(value) + ',';
      return text;
    }



    std::string
    header(const SweepPlan &plan)
    {
      std::string text;
      for (const SweptEntry &entry : plan.entries)
        text += as_field(entry.path) + ',';
      for (const ImpactQuantity &quantity : impact_quantities)
        text += quantity.name + ',';
      return text + "warnings,status";
    }



    std::string
    line(const SweepPlan &plan, const SweepRow &row)
    {
      const bool               is_ok  = row.failure.empty();
      std::vector<std::string> fields = plan.values(row.point);
      for (std::size_t i = 0; i < impact_quantities.size(); ++i)
        fields.push_back(is_ok && !std::isnan(row.quantities[i]) ?
                           shortest(row.quantities[i]) :
                           "");
      fields.push_back(fmt::format("{}", fmt::join(row.warnings, separator)));
      return joined(fields) + as_field(is_ok ? "ok" : row.failure);
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



    /// The first process' side of a sweep: what is written and printed. Rows of
    /// sweep.csv, with the swept values, the quantities of the impact,
    /// warnings, and `ok` or the reason of the failure, are appended as they
    /// come; finish() puts them in the order of the points.
    class SweepRecord
    {
    public:
      /// @param n_groups  plates that the points share
      /// @param resume    the sweep that was interrupted: its points that
      ///                  succeeded are taken over
      SweepRecord(SweepScene       &scene,
                  const std::size_t n_groups,
                  const bool        resume,
                  const bool        quiet)
        : scene(scene)
        , console(quiet)
        , directory(scene.parameters.output.directory)
        , rows(scene.plan.n_points)
      {
        if (resume)
          {
            check_scene_to_resume(directory, scene);
            read_table();
          }
        else
          directory.clear();
        directory.write_scene(scene.name, scene.text);
        write_table();
        table.open(directory / file_name, std::ios::app);
        n_points = points_to_do().size();
        print_head(n_groups);
      }

      std::vector<std::size_t>
      points_to_do() const
      {
        std::vector<std::size_t> points;
        for (std::size_t point = 0; point < rows.size(); ++point)
          if (!rows[point])
            points.push_back(point);
        return points;
      }

      void
      add(SweepRow &&row)
      {
        work.meshes += row.work.meshes;
        work.plates += row.work.plates;
        work.loads += row.work.loads;
        if (!row.history.states.empty())
          {
            directory.write_file("contact_history_point_" +
                                   std::to_string(row.point + 1) + ".csv",
                                 [&](std::ostream &out) {
                                   row.history.write(out);
                                 });
            // the table, which may have a million rows, is not to hold them all
            if (++n_histories > most_plotted_histories)
              row.history = {};
          }
        table << line(scene.plan, row) << '\n' << std::flush;
        if (!table)
          throw ComputationError(
            (directory / file_name).string() +
            " cannot be written: " + std::generic_category().message(errno));
        rows[row.point] = row;
        show(row);
      }

      void
      finish()
      {
        for (const std::size_t point : points_to_do())
          add({point, {}, "not computed: its process ended early", {}, {}});
        table.close();
        write_table();
        if (scene.parameters.output.write_report)
          directory.write_file("sweep.html", sweep_page(scene, rows, work));
        const double seconds = timer.wall_time();
        console.print("\nComputed    " + counted(n_computed, "point") + " in " +
                      about(seconds) + " s, " + about(n_computed / seconds) +
                      " points/s\nMade        " + counted(work.meshes, "mesh") +
                      ", " + counted(work.plates, "plate model") + ", " +
                      counted(work.loads, "response") +
                      " to a load\nResults     " + directory.main_files() +
                      '\n');
        const std::vector<std::string> warnings = sweep_warnings(rows);
        if (std::none_of(rows.begin(), rows.end(), [](const auto &row) {
              return row->failure.empty();
            }))
          throw ComputationError(warnings.front());
        print_warnings(warnings);
      }

      /// What Ctrl-C leaves.
      std::string
      kept() const
      {
        return std::to_string(scene.plan.n_points - points_to_do().size()) +
          " of " + counted(scene.plan.n_points, "point") + " are in " +
          (directory / file_name).string() + "; --resume goes on from there";
      }

    private:
      void
      read_table()
      {
        const SweepPlan                        &plan = scene.plan;
        std::multimap<std::string, std::size_t> points;
        for (std::size_t point = 0; point < plan.n_points; ++point)
          points.emplace(joined(plan.values(point)), point);

        std::ifstream     in(directory / file_name);
        std::string       text;
        const std::size_t n_values     = plan.entries.size(),
                          n_quantities = impact_quantities.size();
        // a line without its end was being written when the sweep was
        // interrupted
        if (!std::getline(in, text) || text != header(plan))
          return;
        while (std::getline(in, text) && !in.eof())
          {
            const std::vector<std::string> fields = split(text);
            if (fields.size() != n_values + n_quantities + 2 ||
                fields.back() != "ok")
              continue;
            SweepRow row;
            row.quantities.resize(n_quantities, std::nan(""));
            for (std::size_t i = 0; i < n_quantities; ++i)
              to_number(fields[n_values + i], row.quantities[i]);
            row.warnings = dealii::Utilities::split_string_list(
              fields[n_values + n_quantities],
              separator);
            const auto [begin, end] = points.equal_range(
              joined({fields.begin(), fields.begin() + n_values}));
            for (auto place = begin; place != end; ++place)
              {
                row.point       = place->second;
                rows[row.point] = row;
              }
          }
      }

      void
      write_table() const
      {
        directory.write_file(file_name, [this](std::ostream &file) {
          file << header(scene.plan) << '\n';
          for (const std::optional<SweepRow> &row : rows)
            if (row)
              file << line(scene.plan, *row) << '\n';
        });
      }

      void
      print_head(const std::size_t n_groups)
      {
        const SweepPlan &plan = scene.plan;
        std::string text = emphasized(scene.name, fmt::emphasis::bold) + ": " +
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
                  column(14, shown.format, shown.factor * row.quantities[i]);
        console.print(text + '\n');
      }

      SweepScene           &scene;
      Console               console;
      const ResultDirectory directory;
      std::ofstream         table;
      std::size_t           n_points; ///< without those before
      const dealii::Timer   timer;
      std::size_t           n_computed = 0;
      SweepWork             work; ///< for these
      std::size_t           n_histories = 0;

      std::vector<std::optional<SweepRow>> rows; ///< none of points to come
    };
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
    const SweepGroups          groups(scene.plan, scene.parameters);
    std::optional<SweepRecord> record;
    std::vector<std::size_t>   to_do;
    std::exception_ptr         failure;
    if (processes.rank == 0)
      try
        {
          record.emplace(scene, groups.groups.size(), resume, quiet);
          to_do = record->points_to_do();
        }
      catch (...)
        {
          failure = std::current_exception();
        }
    if (processes.size > 1)
      to_do = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, to_do);
    if (failure)
      std::rethrow_exception(failure);

    try
      {
        processes.compute(scene, groups, to_do, [&record](SweepRow &&row) {
          record->add(std::move(row));
        });
        if (record)
          record->finish();
      }
    catch (const Interruption &interruption)
      {
        throw interruption.with(record->kept());
      }
  }
} // namespace PlateImpact
