#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace PlateImpact
{
  /// What a plate needs of a mesh of Gmsh.
  struct MshFile
  {
    std::vector<dealii::Point<3>> vertices; ///< nodes of cells, in their
                                            ///< order there
    std::vector<dealii::CellData<2>> cells;
    std::vector<std::string>         edges; ///< physical groups of curves
    /// Their numbers, of the sides that they have; the lower vertex first.
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> edge_of_side;
  };


  /// Reads Gmsh's MSH file format (Gmsh reference manual), versions 2 and 4.1,
  /// as text. Every node of an element is among those of the file, and memory
  /// is taken for what the file holds, whatever it announces. Not by Gmsh,
  /// which obeys a file of options beside the mesh, commands of the shell among
  /// it; nor by dealii::GridIn, which trusts the numbers of a damaged file.
  ///
  /// @throws InputError  a sentence that goes on from the name of the file
  MshFile
  read_msh_file(const std::string &path);
} // namespace PlateImpact
