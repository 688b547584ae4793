#pragma once

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// Gmsh is one for the whole program: started here and ended here. Silent.
  class GmshSession
  {
  public:
    GmshSession()
    {
      gmsh::initialize(0, nullptr, /*readConfigFiles=*/false);
      gmsh::option::setNumber("General.Terminal", 0);
      gmsh::option::setNumber("General.NumThreads", 1);
    }

    ~GmshSession()
    {
      gmsh::finalize();
    }

    GmshSession(const GmshSession &) = delete;
  };


  /// Quadrilaterals as Gmsh makes them.
  struct QuadMesh
  {
    std::vector<dealii::Point<2>>            vertices;
    std::vector<std::array<unsigned int, 4>> cells; ///< counter-clockwise

    /// Smallest scaled Jacobian, the sine of the angle at a corner, over all
    /// corners: 1 for rectangles, 0 and less for cells turned inside out.
    double
    worst_scaled_jacobian() const
    {
      double worst = 1.;
      for (const auto &cell : cells)
        for (unsigned int v = 0; v < 4; ++v)
          {
            const dealii::Point<2> &corner = vertices[cell[v]];
            const auto              a = vertices[cell[(v + 1) % 4]] - corner,
                       b              = vertices[cell[(v + 3) % 4]] - corner;
            const double lengths      = a.norm() * b.norm(),
                         area         = a[0] * b[1] - a[1] * b[0];
            worst = std::min(worst, lengths > 0. ? area / lengths : 0.);
          }
      return worst;
    }
  };


  /// A way to mesh with Gmsh, by the numbers of its options.
  struct MesherSettings
  {
    std::string name; ///< in warnings
    int         algorithm;
    int         recombination; ///< Mesh.RecombinationAlgorithm; -1: none
    int         subdivision;   ///< Mesh.SubdivisionAlgorithm; 1: into quads
    double      size_factor;   ///< from target to Gmsh's size
  };


  /// Frontal Delaunay with Blossom, whose recombination halves the edges of a
  /// twice coarser mesh; then triangles cut into three quadrilaterals each,
  /// which halves theirs and cannot fail once there are triangles.
  inline const std::vector<MesherSettings> default_mesher_settings = {
    {"Blossom recombination", 6, 3, 0, 1.},
    {"triangles cut into quadrilaterals", 5, -1, 1, 2.}};


  /// Meshes a polygon with quadrilaterals by Gmsh (Geuzaine & Remacle 2009,
  /// doi:10.1002/nme.2579): frontal Delaunay triangles, recombined into
  /// quadrilaterals by perfect matching (Remacle et al. 2012,
  /// doi:10.1002/nme.3279). The longest side of the cells has the target size
  /// on average, and scatters around it by about a third. The same input gives
  /// the same mesh. Cells with a scaled Jacobian below 0.15 are refused.
  ///
  /// @param corners   of the domain, counter-clockwise, each a vertex of the
  ///                  mesh. Vertices between two corners of equal x or y have
  ///                  exactly that x or y.
  /// @param inside    points of the domain that are vertices too
  /// @param old_mesh  covers the domain
  /// @param sizes     wanted at its vertices, bilinear between them [m]
  /// @param warnings  told why settings were given up, if any were
  /// @param attempts  settings to try, in this order
  /// @throws ComputationError when no settings give a mesh of quadrilaterals
  QuadMesh
  mesh_by_gmsh(
    const std::vector<dealii::Point<2>> &corners,
    const std::vector<dealii::Point<2>> &inside,
    const dealii::Triangulation<2>      &old_mesh,
    const std::vector<double>           &sizes,
    std::vector<std::string>            &warnings,
    const std::vector<MesherSettings>   &attempts = default_mesher_settings);
} // namespace PlateImpact
