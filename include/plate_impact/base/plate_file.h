#ifndef plate_impact_base_plate_file_h
#define plate_impact_base_plate_file_h

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// A point in the plane of the plate. [m]
  using PlanePoint = std::array<double, 2>;

  /// Two vertices of a plate's file, by their numbers.
  using VertexPair = std::array<unsigned int, 2>;


  /// The outline and the first mesh of a plate that a file of Gmsh holds.
  /// Lengths are in metres, points from the middle of the rectangle around it.
  struct PlateFile
  {
    /// A side of a cell on the boundary.
    struct Side
    {
      VertexPair                  vertices;
      unsigned int                edge;
      std::optional<unsigned int> arc; ///< that it is part of
    };

    struct Arc
    {
      PlanePoint centre;
      double     radius;
    };

    std::string                              path;
    std::vector<PlanePoint>                  vertices;
    std::vector<std::array<unsigned int, 4>> cells; ///< counterclockwise
    std::vector<Side>                        sides;
    std::vector<Arc>                         arcs;
    std::vector<std::string> edges; ///< names of the physical groups; empty:
                                    ///< of sides that belong to none
    std::array<double, 2> extent;   ///< of the rectangle around it
    double                area;
    double                longest_side; ///< of its cells

    /// From a point to the nearest edge; negative outside of the plate.
    double
    distance_to_edge(const PlanePoint &point) const;

    /// The same along an axis, either way.
    double
    distance_to_edge(const PlanePoint &point, unsigned int axis) const;

    /// The corners of a boundary with short chords in place of arcs, by pairs.
    std::vector<std::array<PlanePoint, 2>> outline;
  };


  double
  distance(const PlanePoint &a, const PlanePoint &b);

  /// The pair that both cells along a side have.
  VertexPair
  sorted(unsigned int a, unsigned int b);

  /// The corners of the rectangle around points, lower left and upper right.
  std::array<PlanePoint, 2>
  box_around(const std::vector<PlanePoint> &points);

  /// Coordinates for a sentence.
  std::string
  place(const PlanePoint &point);

  /// @throws InputError  a sentence that goes on from the name of the file
  [[noreturn]] void
  refuse_file(const std::string &sentence);
} // namespace PlateImpact

#endif
