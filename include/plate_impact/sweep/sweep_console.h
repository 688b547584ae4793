#ifndef plate_impact_sweep_sweep_console_h
#define plate_impact_sweep_sweep_console_h

#include "plate_impact/output/console.h"
#include "plate_impact/scene/sweep_scene.h"
#include "plate_impact/sweep/sweep_computation.h"
#include "plate_impact/sweep/sweep_table.h"

#include <chrono>
#include <string>

namespace PlateImpact
{
  /// What a user sees while a sweep runs.
  class SweepConsole
  {
  public:
    /// @param scene  must outlive the console
    /// @param quiet  prints nothing
    SweepConsole(const SweepScene &scene, bool quiet);

    /// @param n_groups  plates that the points share
    /// @param n_done    points taken over from an interrupted sweep
    void
    begin(std::size_t n_groups, std::size_t n_done);

    /// A line per point of a small sweep; of a large one, on a terminal, the
    /// number of points done so far and the time that the others take.
    void
    row(const SweepRow &row);

    void
    end(const SweepWork &work, const std::string &results);

  private:
    const SweepScene &scene;
    Console           console;
    std::size_t       n_points = 0, n_computed = 0;

    const std::chrono::steady_clock::time_point start =
      std::chrono::steady_clock::now();
  };
} // namespace PlateImpact

#endif
