#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What a plate needs of a mesh of Gmsh. Nodes are numbered from 0 as they
  /// come in the file.
  struct MshFile
  {
    /// A line of two nodes, once for each physical group that it is in.
    struct Side
    {
      std::array<unsigned int, 2> nodes;
      unsigned int                group;
    };

    std::vector<dealii::Point<3>>       nodes;
    std::vector<dealii::CellData<2>>    cells;
    std::vector<Side>                   sides;
    std::map<unsigned int, std::string> groups; ///< of curves, and their names
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

  /// @throws InputError  a sentence that goes on from the name of the file
  [[noreturn]] void
  refuse_file(const std::string &sentence);
} // namespace PlateImpact
