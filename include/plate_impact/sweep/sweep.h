#pragma once

#include <deal.II/base/mpi.h>

#include "plate_impact/contact/contact_history.h"
#include "plate_impact/scene/scene.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What was made for a point of a sweep, or for all.
  struct SweepWork
  {
    unsigned int meshes = 0; ///< adapted ones with those before them
    unsigned int plates = 0; ///< models that points were computed on
    unsigned int loads  = 0; ///< responses or reductions
  };


  /// What became of a point.
  struct SweepRow
  {
    std::size_t         point = 0;
    std::vector<double> quantities;    ///< NaN: none; empty for a failed point
    std::string         failure;       ///< the reason, in one line
    std::vector<std::string> warnings; ///< a sentence each, as of `run`
    ContactHistory           history;  ///< without states: not wanted
    SweepWork                work = {};

    /// For the way from one process to another.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &point &quantities &failure &warnings &history;
      archive &work.meshes &work.plates &work.loads;
    }
  };


  /// How many points of a sweep failed, and how many have warnings that differ
  /// in their numbers only, with the first of each kind.
  std::vector<std::string>
  sweep_warnings(const std::vector<std::optional<SweepRow>> &rows);

  /// sweep.html: the range of the force, the quantities of the points over the
  /// swept values, histories and the table.
  /// @param rows  of all points, some with their histories
  std::string
  sweep_page(const SweepScene                           &scene,
             const std::vector<std::optional<SweepRow>> &rows,
             const SweepWork                            &work);


  /// The processes that share a sweep: those that mpirun has started, or this
  /// one alone, without MPI, whose start takes longer than a small scene. A
  /// common counter hands out shares of the points, results go to the first
  /// process.
  class Processes
  {
  public:
    Processes();
    ~Processes();

    Processes(const Processes &) = delete;

    /// Computes points, a share of them on each process: those of one group
    /// after another on one struck plate, if adaptive on the last mesh of the
    /// worst, the one with the shortest contact in Zener's equation, then with
    /// the largest force. Whatever goes wrong with a point becomes the failure
    /// of its row.
    /// @param to_do  in ascending order
    /// @param take   called on the first process with every point, whoever has
    ///              computed it
    /// @throws Interruption, between two points
    /// @throws ComputationError that `take` throws, after which nobody goes on
    void
    compute(SweepScene                             &scene,
            const SweepGroups                      &groups,
            const std::vector<std::size_t>         &to_do,
            const std::function<void(SweepRow &&)> &take);

    int size = 1, rank = 0; ///< rank 0 is the first process

  private:
    /// The next number of 0, 1, 2, ... that no process has been given.
    std::size_t
    next_share();

    const bool     uses_mpi;
    MPI_Win        window; ///< with the counter of the first process
    unsigned long *shared_counter = nullptr;
    std::size_t    counter        = 0; ///< without MPI
  };
} // namespace PlateImpact
