#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace PlateImpact
{
  struct Arc
  {
    dealii::Point<2> centre;
    double           radius;
  };

  /// The outline and the first mesh of a plate that a file of Gmsh holds.
  /// In metres.
  struct PlateFile
  {
    std::string path;

    /// Boundary ids are edge_named and the number of the edge, manifold ids
    /// those of arcs.
    dealii::Triangulation<2> mesh{
      dealii::Triangulation<2>::limit_level_difference_at_vertices};

    std::vector<Arc>         arcs;
    std::vector<std::string> edges; ///< names of the physical groups; empty:
                                    ///< of sides that belong to none
    std::array<double, 2> extent;   ///< of the rectangle around it
    dealii::Point<2>      centre;   ///< of that
    double                area;

    /// The boundary with short chords in place of arcs.
    std::vector<std::array<dealii::Point<2>, 2>> outline;
  };


  /// Reads a mesh of quadrilaterals that Gmsh has written (read_msh_file()).
  /// Physical groups of curves name the edges, and chords into which Gmsh has
  /// cut an arc become one again.
  ///
  /// @throws InputError  a sentence that goes on from the name of the file
  std::shared_ptr<const PlateFile>
  read_plate_file(const std::string &path);
} // namespace PlateImpact
