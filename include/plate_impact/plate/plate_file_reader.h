#ifndef plate_impact_plate_plate_file_reader_h
#define plate_impact_plate_plate_file_reader_h

#include "plate_impact/base/plate_file.h"

#include <memory>
#include <string>

namespace PlateImpact
{
  /// Reads a mesh of quadrilaterals that Gmsh has written (read_msh_file()).
  /// Physical groups of curves name the edges. A row of sides of
  /// one edge whose vertices lie on a circle, nine or more to a full turn, is
  /// taken as the arc that Gmsh has cut into chords: on a polygon a simple
  /// support is another (Babuska's paradox).
  ///
  /// @throws InputError  a sentence that goes on from the name of the file
  std::shared_ptr<const PlateFile>
  read_plate_file(const std::string &path);
} // namespace PlateImpact

#endif
