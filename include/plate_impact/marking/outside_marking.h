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
  class OutsideMarking : public AdaptationControl
  {
  public:
    /// @param command     empty: the cells are marked by their errors
    /// @param adaptivity  with a strategy that gives cells the wanted sizes
    /// @param directory   for the files; must outlive this object
    OutsideMarking(const std::string          &command,
                   const AdaptivityParameters &adaptivity,
                   const ResultDirectory      &directory)
      : AdaptationControl(adaptivity)
      , command(command)
      , directory(directory)
    {}

    /// Those by which the strategy gives the cells the sizes that are wanted.
    /// @throws ComputationError where the command fails, takes more than a
    ///         minute, or answers what is no marking
    ErrorRatios
    error_ratios(const Cycle &cycle) const override;

  private:
    const std::string      command;
    const ResultDirectory &directory;
  };
} // namespace PlateImpact
