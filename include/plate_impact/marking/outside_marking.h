#pragma once

#include "plate_impact/analysis/goal.h"
#include "plate_impact/output/result_directory.h"

#include <string>

namespace PlateImpact
{
  /// Meshes as a command outside of the program wants them. After each mesh it
  /// is run by the shell with the name of a file as its last argument, in
  /// which the program has written the mesh and what it knows of its errors
  /// (doc/results.md has the keys), and answers on its standard output in JSON:
  /// `{"refine": [...], "coarsen": [...]}`, numbers of cells, or
  /// `{"sizes": [...]}`, a length for each. [m]
  /// @param command    empty: no marking
  /// @param directory  for the files; must outlive the marking
  /// @return of the cells the ratios by which strategies give them these sizes.
  ///         Throws a ComputationError where the command fails, takes more than
  ///         a minute, or answers what is no marking.
  Marking
  outside_marking(const std::string &command, const ResultDirectory &directory);
} // namespace PlateImpact
