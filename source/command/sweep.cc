#include "plate_impact/command/sweep.h"

#include <deal.II/base/utilities.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/interrupt.h"
#include "plate_impact/base/text.h"
#include "plate_impact/output/result_directory.h"
#include "plate_impact/sweep/sweep_computation.h"
#include "plate_impact/sweep/sweep_console.h"
#include "plate_impact/sweep/sweep_groups.h"
#include "plate_impact/sweep/sweep_page.h"
#include "plate_impact/sweep/sweep_table.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

namespace PlateImpact
{
  using dealii::Utilities::pack;
  using dealii::Utilities::unpack;

  /// A state as its numbers, where Boost finds it.
  template <typename Archive>
  void
  serialize(Archive &archive, ContactState &state, const unsigned int)
  {
    static_assert(sizeof(ContactState) == 11 * sizeof(double));
    archive &state.time &state.force &state.indentation;
    archive &state.plate_displacement &state.impactor_displacement;
    archive                           &state.impactor_velocity;
    archive &state.plate_energy &state.contact_energy &state.impactor_energy;
    archive &state.dissipated_energy &state.permanent_indentation;
  }



  namespace
  {
    /// A scene without what may differ between a sweep and its continuation:
    /// comments and the name of the directory.
    std::string
    essence(std::istream &scene)
    {
      std::string text;
      for (std::string line; std::getline(scene, line);)
        if (!line.empty() && line[0] != '#' &&
            line.find("set Directory ") == std::string::npos)
          text += line + '\n';
      return text;
    }



    /// @throws InputError when the directory holds a sweep of another scene
    void
    check_scene_to_resume(const ResultDirectory &directory,
                          const SweepScene      &scene)
    {
      std::ifstream before(directory / "scene.prm");
      if (!before)
        return;
      std::istringstream now(scene.text());
      std::istringstream a(essence(before)), b(essence(now));
      for (std::string line_before, line; std::getline(b, line);)
        if (!std::getline(a, line_before) || line != line_before)
          throw InputError({"--resume: " + (directory / "scene.prm").string() +
                            " belongs to another sweep: it has '" +
                            dealii::Utilities::trim(line_before) + "' where " +
                            scene.name() + " has '" +
                            dealii::Utilities::trim(line) + "'"});
    }



    /// More histories than these do not show in one plot.
    constexpr std::size_t most_plotted_histories = 12;



    /// The first process' side of a sweep: what is written and printed.
    class SweepRecord
    {
    public:
      SweepRecord(SweepScene &scene, const SweepOptions &options)
        : scene(scene)
        , console(scene, options.quiet)
        , directory(scene.parameters().output.directory)
        , table(prepared(directory, scene, options),
                scene.plan(),
                options.resume)
      {}

      std::vector<std::size_t>
      points_to_do() const
      {
        std::vector<std::size_t> points;
        for (std::size_t point = 0; point < table.rows().size(); ++point)
          if (!table.rows()[point])
            points.push_back(point);
        return points;
      }

      void
      begin(const std::size_t n_groups)
      {
        console.begin(n_groups,
                      scene.plan().n_points() - points_to_do().size());
      }

      void
      add(const SweepRow &row, const std::optional<ContactHistory> &history)
      {
        if (history && histories.size() < most_plotted_histories)
          histories[row.point] = *history;
        if (history)
          directory.write_file("contact_history_point_" +
                                 std::to_string(row.point + 1) + ".csv",
                               [&](std::ostream &out) { history->write(out); });
        table.add(row);
        console.row(row);
      }

      /// What Ctrl-C leaves.
      std::string
      kept() const
      {
        return std::to_string(scene.plan().n_points() - points_to_do().size()) +
          " of " + counted(scene.plan().n_points(), "point") + " are in " +
          (directory / "sweep.csv").string() + "; --resume goes on from there";
      }

      void
      finish(const SweepWork &work)
      {
        for (const std::size_t point : points_to_do())
          add({point, {}, "not computed: its process ended early", {}}, {});
        table.finish();
        if (scene.parameters().output.write_report)
          directory.write_file("sweep.html", [&](std::ostream &out) {
            write_sweep_page(out, scene, table.rows(), histories, work);
          });
        console.end(work, directory.main_files());
        const std::vector<std::string> warnings = sweep_warnings(table.rows());
        if (std::none_of(table.rows().begin(),
                         table.rows().end(),
                         [](const auto &row) { return row->failure.empty(); }))
          throw ComputationError(warnings.front());
        print_warnings(warnings);
      }

    private:
      /// Cleared for another sweep, or with the rows of this one.
      static const ResultDirectory &
      prepared(const ResultDirectory &directory,
               const SweepScene      &scene,
               const SweepOptions    &options)
      {
        if (options.resume)
          check_scene_to_resume(directory, scene);
        else
          directory.clear();
        directory.write_scene(scene.name(), scene.text());
        return directory;
      }

      SweepScene           &scene;
      SweepConsole          console;
      const ResultDirectory directory;
      SweepTable            table;

      std::map<std::size_t, ContactHistory> histories; ///< for the page
    };



    /// What a process sends: a row and its history, or at last its work.
    struct Message
    {
      std::optional<ContactHistory>
      history() const
      {
        if (states.empty())
          return {};
        ContactHistory history;
        for (const ContactState &state : states)
          history.add(state);
        return history;
      }

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &is_work &work.meshes &work.plates &work.loads &states;
        archive &row.point &row.figures &row.failure &row.warnings;
      }

      SweepRow                  row;
      std::vector<ContactState> states;
      bool                      is_work = false;
      SweepWork                 work    = {};
    };



    /// The tasks that this process is given, one after another.
    /// @param done  called with every point's row and history
    void
    compute_tasks(
      const std::vector<SweepGroups::Task> &tasks,
      SweepComputation                     &computation,
      Processes                            &processes,
      const std::function<void(const SweepRow &,
                               const std::optional<ContactHistory> &)> &done)
    {
      for (std::size_t task; (task = processes.next_task()) < tasks.size();)
        for (const std::size_t point : tasks[task].points)
          {
            const auto [row, history] =
              computation.compute(tasks[task].group, point);
            done(row, history);
          }
    }



    /// The share of another process than the first.
    void
    compute_for_first(const std::vector<SweepGroups::Task> &tasks,
                      SweepComputation                     &computation,
                      Processes                            &processes)
    {
      compute_tasks(
        tasks,
        computation,
        processes,
        [&](const SweepRow &row, const std::optional<ContactHistory> &history) {
          processes.send(pack(Message{row,
                                      history ? history->states() :
                                                std::vector<ContactState>()},
                              false));
        });
      processes.send(pack(Message{{}, {}, true, computation.work()}, false));
      processes.send({});
    }



    /// The share of the first process, and what the others send.
    SweepWork
    compute_and_receive(const std::vector<SweepGroups::Task> &tasks,
                        SweepComputation                     &computation,
                        Processes                            &processes,
                        SweepRecord                          &record)
    {
      SweepWork  of_others;
      const auto receive = [&](const bool wait) {
        for (const std::vector<char> &bytes : processes.receive(wait))
          {
            const auto message = unpack<Message>(bytes, false);
            if (message.is_work)
              of_others += message.work;
            else
              record.add(message.row, message.history());
          }
      };
      try
        {
          compute_tasks(tasks,
                        computation,
                        processes,
                        [&](const SweepRow                      &row,
                            const std::optional<ContactHistory> &history) {
                          record.add(row, history);
                          throw_if_interrupted();
                          receive(/*wait=*/false);
                        });
          while (!processes.all_ended())
            receive(/*wait=*/true);
        }
      catch (const ComputationError &)
        {
          // nothing can be written: nothing more is computed
          while (processes.next_task() < tasks.size())
            ;
          while (!processes.all_ended())
            processes.receive(/*wait=*/true);
          throw;
        }
      SweepWork all = computation.work();
      all += of_others;
      return all;
    }
  } // namespace



  void
  run_sweep(SweepScene         &scene,
            const SweepOptions &options,
            Processes          &processes)
  {
    // mpirun has its own way to end processes
    if (processes.size() > 1)
      await_no_interrupt();
    // the first process alone reads and writes results; without any it has
    // nothing to do for the others
    std::unique_ptr<SweepRecord> record;
    std::vector<std::size_t>     to_do;
    std::exception_ptr           failure;
    if (processes.is_first())
      try
        {
          record = std::make_unique<SweepRecord>(scene, options);
          to_do  = record->points_to_do();
        }
      catch (...)
        {
          failure = std::current_exception();
        }
    processes.broadcast(to_do);
    if (failure)
      std::rethrow_exception(failure);

    const SweepGroups groups(scene.plan(),
                             scene.may_adapt(),
                             scene.is_laminate());
    std::vector<bool> is_to_do(scene.plan().n_points(), false);
    for (const std::size_t point : to_do)
      is_to_do[point] = true;
    // a few tasks for each process, so that all end at about the same time
    const std::size_t n_parts =
      processes.size() == 1 ? 1 : 8 * processes.size();
    const auto tasks =
      groups.tasks(is_to_do, std::max<std::size_t>(1, to_do.size() / n_parts));

    SweepComputation computation(scene, groups);
    if (!record)
      return compute_for_first(tasks, computation, processes);
    record->begin(groups.groups().size());
    try
      {
        record->finish(
          compute_and_receive(tasks, computation, processes, *record));
      }
    catch (const Interruption &interruption)
      {
        throw Interruption(std::string(interruption.what()) + ": " +
                             record->kept(),
                           interruption.signal);
      }
  }
} // namespace PlateImpact
