#include "plate_impact/sweep/processes.h"

#include "plate_impact/base/exceptions.h"

#include <boost/serialization/is_bitwise_serializable.hpp>
#include <boost/serialization/vector.hpp>

#include <cstdlib>
#include <optional>
#include <utility>

// sent as its numbers, in one piece
BOOST_IS_BITWISE_SERIALIZABLE(PlateImpact::ContactState)

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Whether mpirun or a batch system has started this process, by the
    /// variables of Open MPI, of MPICH and its relatives, and of PMIx.
    bool
    is_started_by_mpi()
    {
      for (const char *name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
        if (std::getenv(name) != nullptr)
          return true;
      return false;
    }



    /// To the first process, without waiting for it as long as they are few.
    /// @param bytes  of a point; none: no other follows
    void
    send(const std::vector<char> &bytes)
    {
      MPI_Send(bytes.data(), bytes.size(), MPI_CHAR, 0, 0, MPI_COMM_WORLD);
    }



    /// What another process has sent.
    /// @param wait  for something
    std::optional<std::vector<char>>
    received(const bool wait)
    {
      int        has_come = 1;
      MPI_Status status;
      if (wait)
        MPI_Probe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &status);
      else
        MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &has_come, &status);
      if (!has_come)
        return {};
      int n_bytes;
      MPI_Get_count(&status, MPI_CHAR, &n_bytes);
      std::vector<char> bytes(n_bytes);
      MPI_Recv(bytes.data(),
               n_bytes,
               MPI_CHAR,
               status.MPI_SOURCE,
               0,
               MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
      return bytes;
    }
  } // namespace



  Processes::Processes()
    : uses_mpi(is_started_by_mpi())
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
  Processes::next_task()
  {
    if (!uses_mpi)
      return counter++;
    const unsigned long one = 1;
    unsigned long       task;
    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, window);
    MPI_Fetch_and_op(&one, &task, MPI_UNSIGNED_LONG, 0, 0, MPI_SUM, window);
    MPI_Win_unlock(0, window);
    return task;
  }



  SweepWork
  Processes::compute(const std::vector<SweepGroups::Task>   &tasks,
                     SweepComputation                       &computation,
                     const std::function<void(SweepRow &&)> &take)
  {
    SweepWork  all;
    const auto add = [&](SweepRow &&row) {
      all.meshes += row.work.meshes;
      all.plates += row.work.plates;
      all.loads += row.work.loads;
      take(std::move(row));
    };
    int        n_others    = rank == 0 ? size - 1 : 0; // that go on
    const auto take_others = [&](const bool wait, const auto &take) {
      while (n_others > 0)
        {
          const auto bytes = received(wait);
          if (!bytes)
            return;
          if (bytes->empty())
            --n_others;
          else
            take(Utilities::unpack<SweepRow>(*bytes, false));
        }
    };
    try
      {
        for (std::size_t task; (task = next_task()) < tasks.size();)
          for (const std::size_t index : tasks[task].points)
            {
              SweepRow row = computation.compute(tasks[task].group, index);
              if (rank == 0)
                {
                  add(std::move(row));
                  throw_if_interrupted();
                  take_others(/*wait=*/false, add);
                }
              else
                send(Utilities::pack(row, false));
            }
        if (rank != 0)
          send({});
        take_others(/*wait=*/true, add);
      }
    catch (const ComputationError &)
      {
        // nothing can be written: nothing more is computed
        while (next_task() < tasks.size())
          ;
        take_others(/*wait=*/true, [](SweepRow &&) {});
        throw;
      }
    return all;
  }
} // namespace PlateImpact
