#include "plate_impact/sweep/processes.h"

#include <deal.II/base/mpi.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/interrupt.h"
#include "plate_impact/sweep/sweep_computation.h"

#include <boost/serialization/is_bitwise_serializable.hpp>
#include <boost/serialization/vector.hpp>

#include <cstdlib>

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


    /// What a process sends: a point, with the states of its history, or at
    /// last its work.
    struct Message
    {
      Message() = default;

      explicit Message(const ComputedPoint &point)
        : row(point.row)
      {
        if (point.history)
          states = point.history->states();
      }

      explicit Message(const SweepWork &work)
        : is_work(true)
        , work(work)
      {}

      ComputedPoint
      computed() const
      {
        ComputedPoint point{row, {}};
        if (!states.empty())
          point.history.emplace();
        for (const ContactState &state : states)
          point.history->add(state);
        return point;
      }

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &is_work &work.meshes &work.plates &work.loads &states;
        archive &row.point &row.quantities &row.failure &row.warnings;
      }

      SweepRow                  row;
      std::vector<ContactState> states;
      bool                      is_work = false;
      SweepWork                 work;
    };
  } // namespace



  /// What needs MPI: the shared counter.
  struct Processes::Connection
  {
    Connection()
    {
      MPI_Init(nullptr, nullptr);
      int number;
      MPI_Comm_rank(MPI_COMM_WORLD, &number);
      rank = number;
      MPI_Comm_size(MPI_COMM_WORLD, &number);
      size = number;
      MPI_Win_allocate(rank == 0 ? sizeof(*counter) : 0,
                       sizeof(*counter),
                       MPI_INFO_NULL,
                       MPI_COMM_WORLD,
                       &counter,
                       &window);
      if (rank == 0)
        {
          MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window);
          *counter = 0;
          MPI_Win_unlock(0, window);
        }
      MPI_Barrier(MPI_COMM_WORLD);
    }

    ~Connection()
    {
      MPI_Win_free(&window);
      MPI_Finalize();
    }

    unsigned int   rank, size;
    MPI_Win        window;
    unsigned long *counter = nullptr; ///< on the first process
  };



  Processes::Processes()
  {
    if (is_started_by_mpi())
      connection = std::make_unique<Connection>();
  }



  Processes::~Processes() = default;



  unsigned int
  Processes::size() const
  {
    return connection ? connection->size : 1;
  }



  bool
  Processes::is_first() const
  {
    return !connection || connection->rank == 0;
  }



  std::size_t
  Processes::next_task()
  {
    if (!connection)
      return counter++;
    const unsigned long one = 1;
    unsigned long       task;
    MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, connection->window);
    MPI_Fetch_and_op(&one,
                     &task,
                     MPI_UNSIGNED_LONG,
                     0,
                     0,
                     MPI_SUM,
                     connection->window);
    MPI_Win_unlock(0, connection->window);
    return task;
  }



  void
  Processes::broadcast(std::vector<std::size_t> &numbers) const
  {
    if (connection)
      numbers = Utilities::MPI::broadcast(MPI_COMM_WORLD, numbers);
  }



  std::vector<std::vector<char>>
  Processes::receive(bool wait)
  {
    std::vector<std::vector<char>> messages;
    while (connection && n_ended + 1 < size())
      {
        int        has_come = 1;
        MPI_Status status;
        if (wait)
          MPI_Probe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &status);
        else
          MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &has_come, &status);
        if (!has_come)
          break;
        wait = false;
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
        if (bytes.empty())
          ++n_ended;
        else
          messages.push_back(std::move(bytes));
      }
    return messages;
  }



  bool
  Processes::all_ended() const
  {
    return n_ended + 1 >= size();
  }



  SweepWork
  Processes::compute(const std::vector<SweepGroups::Task> &tasks,
                     SweepComputation                     &computation,
                     const std::function<void(const ComputedPoint &)> &take)
  {
    const auto send = [](const std::vector<char> &bytes) {
      // without waiting for the first process as long as the message is small
      MPI_Send(bytes.data(), bytes.size(), MPI_CHAR, 0, 0, MPI_COMM_WORLD);
    };
    SweepWork  all;
    const auto add_work = [&all](const SweepWork &work) {
      all.meshes += work.meshes;
      all.plates += work.plates;
      all.loads += work.loads;
    };
    const auto take_others = [&](const bool wait) {
      for (const std::vector<char> &bytes : receive(wait))
        if (const auto message = Utilities::unpack<Message>(bytes, false);
            message.is_work)
          add_work(message.work);
        else
          take(message.computed());
    };
    try
      {
        for (std::size_t task; (task = next_task()) < tasks.size();)
          for (const std::size_t index : tasks[task].points)
            {
              const ComputedPoint point =
                computation.compute(tasks[task].group, index);
              if (is_first())
                {
                  take(point);
                  throw_if_interrupted();
                  take_others(/*wait=*/false);
                }
              else
                send(Utilities::pack(Message(point), false));
            }
        if (!is_first())
          {
            send(Utilities::pack(Message(computation.work()), false));
            send({});
          }
        while (is_first() && !all_ended())
          take_others(/*wait=*/true);
      }
    catch (const ComputationError &)
      {
        // nothing can be written: nothing more is computed
        while (next_task() < tasks.size())
          ;
        while (!all_ended())
          receive(/*wait=*/true);
        throw;
      }
    add_work(computation.work());
    return all;
  }
} // namespace PlateImpact
