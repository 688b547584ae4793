#include <deal.II/base/utilities.h>

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/sweep/sweep.h"

#include <boost/serialization/is_bitwise_serializable.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <tuple>
#include <utility>

// sent as its numbers, in one piece
BOOST_IS_BITWISE_SERIALIZABLE(PlateImpact::ContactState)

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Why a call fails; empty when it does not.
    template <typename Function>
    std::string
    failure_of(const Function &function)
    {
      try
        {
          function();
          return {};
        }
      catch (const Interruption &)
        {
          throw; // not the point's failure
        }
      catch (const std::bad_alloc &)
        {
          return "not enough memory";
        }
      catch (const ExceptionBase &error)
        {
          return std::string("an internal error: ") + error.get_exc_name();
        }
      catch (const std::exception &error)
        {
          return Utilities::replace_in_string(error.what(), "\n", "; ");
        }
    }



    /// Computes points, those of a group one after another on the same plate.
    struct SweepComputation
    {
      SweepScene        &scene;
      const SweepGroups &groups;

      SweepWork                         work = {}; ///< since the last point
      std::optional<std::size_t>        current_group = {};
      std::unique_ptr<Triangulation<2>> mesh          = {}; ///< of this group
      double                   min_cell_size = 0.; ///< of this mesh [m]
      std::string              failure       = {}; ///< why there is none
      std::vector<std::string> mesh_warnings = {}; ///< of this mesh

      /// Of the current group, by the mass that its impactors need.
      std::map<PlateMass, PlateModel> plate_models = {};

      /// Whatever goes wrong becomes the failure of the row.
      SweepRow
      compute(const std::size_t group, const std::size_t point)
      {
        SweepRow row;
        row.point   = point;
        row.failure = failure_of([&] {
          const SweepPoint valid  = scene.point(point);
          auto [result, warnings] = compute(group, valid);
          const ComputedImpact impact{valid.parameters, valid.expected, result};
          for (const ImpactQuantity &quantity : impact_quantities)
            row.quantities.push_back(
              quantity.value(impact).value_or(std::nan("")));
          row.warnings = std::move(warnings);
          row.warnings.insert(row.warnings.end(),
                              mesh_warnings.begin(),
                              mesh_warnings.end());
          if (valid.parameters.sweep.write_histories)
            row.history = std::move(*result.history);
        });
        row.work    = std::exchange(work, {});
        return row;
      }

      /// With its warnings, without those of a shared mesh.
      using Computed = std::pair<CycleResult, std::vector<std::string>>;

      Computed
      compute(const std::size_t group, const SweepPoint &point)
      {
        const Parameters &parameters = point.parameters;
        if (parameters.adaptivity.is_adaptive() &&
            parameters.sweep.adapts_each_point)
          return analyse(parameters, nullptr);

        if (current_group != group)
          {
            plate_models.clear();
            mesh.reset();
            mesh_warnings.clear();
            current_group = group;
            failure       = failure_of([&] {
              mesh          = make_mesh(group, point);
              min_cell_size = smallest_cell_size(*mesh);
            });
          }
        if (mesh == nullptr)
          throw ComputationError("the plate of this point: " + failure);

        if (parameters.sweep.estimate_error)
          {
            Parameters on_mesh          = parameters;
            on_mesh.adaptivity.strategy = AdaptationStrategy::none;
            return analyse(on_mesh, copy_of(*mesh));
          }
        const PlateMass mass = parameters.discretization.mass;
        if (plate_models.count(mass) == 0)
          {
            plate_models.try_emplace(mass,
                                     parameters.plate,
                                     parameters.discretization,
                                     copy_of(*mesh));
            ++work.plates;
          }
        return strike(point, plate_models.at(mass));
      }

      /// The impact on the struck plate.
      Computed
      strike(const SweepPoint &point, PlateModel &plate_model)
      {
        const unsigned int loads_before = plate_model.work().loads;
        const bool         needs_states = point.parameters.needs_estimator();
        const Parameters   parameters =
          until_contact_ends(plate_model, point.parameters, needs_states);
        const LoadedPlate plate  = plate_model.under(parameters, needs_states);
        const Impact      impact = plate.strike();
        work.loads += plate_model.work().loads - loads_before;

        CycleResult result;
        result.history       = impact.history;
        result.impulse       = impact.impulse;
        result.sensitivity   = plate.sensitivity(impact.history);
        result.min_cell_size = min_cell_size;
        // an adapted mesh was judged with the worst point
        const Warnings warnings =
          impact_warnings({parameters, point.expected, result},
                          parameters.adaptivity.is_adaptive() ? nullptr :
                                                                mesh.get());
        return {std::move(result), warnings.all()};
      }

      /// The mesh of a group, made for the worst of its valid points.
      std::unique_ptr<Triangulation<2>>
      make_mesh(const std::size_t group, const SweepPoint &point)
      {
        ++work.meshes;
        if (!point.parameters.adaptivity.is_adaptive())
          return make_plate_mesh(point.parameters.plate,
                                 point.parameters.discretization.initial_cells);
        std::optional<SweepPoint> worst;
        const auto                severity = [](const SweepPoint &point) {
          return std::make_tuple(-point.expected.peak.time,
                                 point.expected.peak.force);
        };
        for (const std::size_t index : groups.groups[group])
          try
            {
              const SweepPoint other = scene.point(index);
              if (!worst || severity(other) > severity(*worst))
                worst = other;
            }
          catch (const InputError &)
            {
              // it gets its row when its turn comes
            }
        ImpactAnalysis analysis(worst->parameters);
        analysis.run();
        mesh_warnings           = analysis.warnings;
        const CycleResult &last = analysis.last_cycle().result;
        work.meshes += last.cycle - 1;
        if (const std::string warning =
              AdaptationControl(worst->parameters.adaptivity).warning(last);
            !warning.empty())
          mesh_warnings.push_back(
            "on the mesh adapted for the point with the shortest contact, " +
            warning);
        return copy_of(analysis.last_cycle().mesh());
      }

      /// With the error, and on better meshes where the parameters say so.
      Computed
      analyse(const Parameters                 &parameters,
              std::unique_ptr<Triangulation<2>> mesh)
      {
        ImpactAnalysis analysis(parameters,
                                std::move(mesh),
                                Wanted{/*errors=*/true});
        analysis.run();
        const CycleResult &last = analysis.last_cycle().result;
        if (parameters.adaptivity.is_adaptive())
          work.meshes += last.cycle;
        work.plates += last.cycle;
        work.loads += last.cycle;
        return {last, analysis.all_warnings().all()};
      }
    };



    /// Groups and points, those of a group one after another.
    /// @param to_do  points in ascending order
    std::vector<std::pair<std::size_t, std::size_t>>
    tasks_of(const std::vector<std::vector<std::size_t>> &groups,
             const std::vector<std::size_t>              &to_do)
    {
      std::vector<std::pair<std::size_t, std::size_t>> tasks;
      for (std::size_t group = 0; group < groups.size(); ++group)
        for (const std::size_t point : groups[group])
          if (std::binary_search(to_do.begin(), to_do.end(), point))
            tasks.emplace_back(group, point);
      return tasks;
    }



    /// To the first process, without waiting for it as long as they are few.
    /// @param bytes  of a point; none: no other follows
    void
    send(const std::vector<char> &bytes)
    {
      MPI_Send(bytes.data(), bytes.size(), MPI_CHAR, 0, 0, MPI_COMM_WORLD);
    }



    /// Takes what other processes have sent.
    /// @param n_others  that go on
    /// @param wait      until there is none
    void
    take_others(int                                    &n_others,
                const bool                              wait,
                const std::function<void(SweepRow &&)> &take)
    {
      while (n_others > 0)
        {
          int        has_come = 1, n_bytes;
          MPI_Status status;
          if (wait)
            MPI_Probe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &status);
          else
            MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &has_come, &status);
          if (!has_come)
            return;
          MPI_Get_count(&status, MPI_CHAR, &n_bytes);
          std::vector<char> bytes(n_bytes);
          MPI_Recv(bytes.data(),
                   n_bytes,
                   MPI_CHAR,
                   status.MPI_SOURCE,
                   0,
                   MPI_COMM_WORLD,
                   MPI_STATUS_IGNORE);
          if (bytes.empty())
            --n_others;
          else
            take(Utilities::unpack<SweepRow>(bytes, false));
        }
    }
  } // namespace



  Processes::Processes()
    // started by mpirun or a batch system, by the variables of Open MPI, of
    // MPICH and its relatives, and of PMIx
    : uses_mpi(std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") ||
               std::getenv("PMIX_RANK"))
  {
    if (!uses_mpi)
      return;
    MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    MPI_Win_allocate(rank == 0 ? sizeof(*shared_counter) : 0,
                     sizeof(*shared_counter),
                     MPI_INFO_NULL,
                     MPI_COMM_WORLD,
                     &shared_counter,
                     &window);
    if (rank == 0)
      {
        MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window);
        *shared_counter = 0;
        MPI_Win_unlock(0, window);
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }



  Processes::~Processes()
  {
    if (!uses_mpi)
      return;
    MPI_Win_free(&window);
    MPI_Finalize();
  }



  std::size_t
  Processes::next_share()
  {
    if (!uses_mpi)
      return counter++;
    const unsigned long one = 1;
    unsigned long       share;
    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, window);
    MPI_Fetch_and_op(&one, &share, MPI_UNSIGNED_LONG, 0, 0, MPI_SUM, window);
    MPI_Win_unlock(0, window);
    return share;
  }



  void
  Processes::compute(SweepScene                             &scene,
                     const SweepGroups                      &groups,
                     const std::vector<std::size_t>         &to_do,
                     const std::function<void(SweepRow &&)> &take)
  {
    const auto tasks = tasks_of(groups.groups, to_do);
    // a few shares for each process, so that all end at about the same time
    const std::size_t n = tasks.size(),
                      n_shares =
                        size == 1 ? 1 : std::min<std::size_t>(8 * size, n);
    SweepComputation computation{scene, groups};
    int              n_others = rank == 0 ? size - 1 : 0;
    try
      {
        for (std::size_t share; (share = next_share()) < n_shares;)
          for (std::size_t task = share * n / n_shares;
               task < (share + 1) * n / n_shares;
               ++task)
            {
              SweepRow row =
                computation.compute(tasks[task].first, tasks[task].second);
              if (rank == 0)
                {
                  take(std::move(row));
                  throw_if_interrupted();
                  take_others(n_others, /*wait=*/false, take);
                }
              else
                send(Utilities::pack(row, false));
            }
        if (rank != 0)
          send({});
        take_others(n_others, /*wait=*/true, take);
      }
    catch (const ComputationError &)
      {
        // nothing can be written: nothing more is computed
        while (next_share() < n_shares)
          ;
        take_others(n_others, /*wait=*/true, [](SweepRow &&) {});
        throw;
      }
  }
} // namespace PlateImpact
