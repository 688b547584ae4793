#pragma once

#include "plate_impact/scene/scene.h"
#include "plate_impact/sweep/sweep.h"

#include <string>

/// What `run`, `compare`, `sweep` and `check` do. Where they are quiet, only
/// warnings and errors are printed, and of a run a line for scripts. Files that
/// were written before a ComputationError are valid.
namespace PlateImpact
{
  /// Computes the impact of a scene cycle by cycle, and writes and prints what
  /// is found.
  /// @param marking  a command that says what the next mesh is to be
  ///                 (outside_marking()); empty: none
  /// @throws InputError where there is one and the strategy gives no sizes
  /// @throws ComputationError, of which summary.json tells
  void
  run_scene(const Scene &scene, bool quiet, const std::string &marking);

  /// Computes the comparison of a scene, and writes and prints what is found,
  /// after every mesh and every curve.
  /// @param marking  a command whose meshes are compared as well
  ///                 (outside_marking()); empty: none
  /// @throws InputError for a scene without an impactor
  void
  compare_scene(Scene scene, bool quiet, const std::string &marking);

  /// Computes the points of a sweep, spread over all processes, and writes and
  /// prints what is found. A point that fails has its reason in its row.
  /// @param resume  continues an interrupted sweep
  /// @throws InputError when there is a sweep to resume, of another scene
  /// @throws ComputationError when results cannot be written, or when every
  ///         point failed
  void
  run_sweep(SweepScene &scene, bool resume, bool quiet, Processes &processes);

  /// What to expect of a scene before paying for it: the impact on a coarse
  /// mesh, on Zener's infinite thin plate and on one that does not move, when
  /// waves return from the edges, the wavelength against the cells, advice on
  /// step and end time, a rough cost, what a sweep of it computes, and where
  /// the impact leaves the model.
  /// @throws ComputationError when the impact cannot be computed
  std::string
  expectation_in_words(const Scene &scene);

  /// Does what the command line asks for; errors are printed. The whole
  /// program, apart from main().
  /// @return the exit status: 0 done, 1 the input is wrong, 2 the computation
  ///         failed, 128 and the signal that interrupted it
  int
  run_command_line(int argc, const char *const *argv);
} // namespace PlateImpact
