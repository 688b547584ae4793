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

  /// Makes sides of one edge that are chords of a circle, nine or more to a
  /// full turn, parts of arcs: their manifold id is the number of an arc. On a
  /// polygon a simple support is another (Babuska's paradox).
  /// @param mesh  of one level, with boundary ids
  std::vector<Arc>
  find_arcs(dealii::Triangulation<2> &mesh);


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

    /// From a point to the nearest edge; negative outside of the plate.
    double
    distance_to_edge(const dealii::Point<2> &point) const;

    /// The same along an axis, either way.
    double
    distance_to_edge(const dealii::Point<2> &point, unsigned int axis) const;

    /// The boundary with short chords in place of arcs.
    std::vector<std::array<dealii::Point<2>, 2>> outline;
  };


  /// Reads a mesh of quadrilaterals that Gmsh has written (read_msh_file()).
  /// Physical groups of curves name the edges, and chords into which Gmsh has
  /// cut an arc become one again (find_arcs()).
  ///
  /// @throws InputError  a sentence that goes on from the name of the file
  std::shared_ptr<const PlateFile>
  read_plate_file(const std::string &path);
} // namespace PlateImpact
