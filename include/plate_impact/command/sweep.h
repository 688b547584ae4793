#ifndef plate_impact_command_sweep_h
#define plate_impact_command_sweep_h

#include "plate_impact/scene/sweep_scene.h"
#include "plate_impact/sweep/processes.h"

namespace PlateImpact
{
  struct SweepOptions
  {
    bool resume = false; ///< continue an interrupted sweep
    bool quiet  = false; ///< print warnings and errors only
  };


  /// Computes the points of a sweep, spread over all processes, and writes and
  /// prints what is found. A point that fails has its reason in its row.
  /// @throws InputError when there is a sweep to resume, of another scene
  /// @throws ComputationError when results cannot be written, or when every
  ///         point failed
  void
  run_sweep(SweepScene         &scene,
            const SweepOptions &options,
            Processes          &processes);
} // namespace PlateImpact

#endif
