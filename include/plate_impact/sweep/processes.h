#ifndef plate_impact_sweep_processes_h
#define plate_impact_sweep_processes_h

#include <cstddef>
#include <memory>
#include <vector>

namespace PlateImpact
{
  /// The processes that share a computation: those that mpirun has started, or
  /// this one alone. Tasks are handed out one by one by a counter that all
  /// share, results go to the first process. MPI is started only under mpirun;
  /// its start takes longer than a small scene.
  class Processes
  {
  public:
    Processes();
    ~Processes();

    Processes(const Processes &) = delete;

    unsigned int
    size() const;

    bool
    is_first() const;

    /// The next number of 0, 1, 2, ... that no process has been given.
    std::size_t
    next_task();

    /// Makes the first process' numbers known to all.
    void
    broadcast(std::vector<std::size_t> &numbers) const;

    /// Sends bytes to the first process, which takes them between two points of
    /// its own. Empty ones say that nothing will follow.
    void
    send(const std::vector<char> &bytes);

    /// What has come from the others since the last call; on the first process.
    /// @param wait  for something, as long as some have not sent their end
    std::vector<std::vector<char>>
    receive(bool wait);

    /// Whether all others have sent their end.
    bool
    all_ended() const;

  private:
    struct Connection;

    std::unique_ptr<Connection> connection;  ///< null: this process is alone
    std::size_t                 counter = 0; ///< of a process that is alone
    unsigned int                n_ended = 0;
  };
} // namespace PlateImpact

#endif
