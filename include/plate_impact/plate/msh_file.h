#ifndef plate_impact_plate_msh_file_h
#define plate_impact_plate_msh_file_h

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace PlateImpact
{
  /// What a plate needs of a mesh of Gmsh, by the numbers that the file gives.
  struct MshFile
  {
    using Node = std::uint64_t;

    /// A line of two nodes, once for each physical group that it is in.
    struct Side
    {
      std::array<Node, 2> nodes;
      unsigned int        group;
    };

    std::unordered_map<Node, std::array<double, 3>> nodes; ///< x, y, z
    std::vector<std::array<Node, 4>>                cells;
    std::vector<Side>                               sides;
    std::map<unsigned int, std::string> groups; ///< of curves, and their names
  };


  /// Reads Gmsh's MSH file format, versions 2, 3, 4.0 and 4.1, as text or
  /// binary. Every node of an element is among those of the file, and memory is
  /// taken for what the file holds, whatever it announces. Not by Gmsh itself:
  /// that does what a file of options beside the mesh says, commands of the
  /// shell among it, and trusts the numbers of the file.
  ///
  /// Reference: Gmsh reference manual, "MSH file format".
  ///
  /// @throws InputError  a sentence that goes on from the name of the file
  MshFile
  read_msh_file(const std::string &path);
} // namespace PlateImpact

#endif
