#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What follows from the outline of a plate and the place of the impact.
  struct PlateGeometry
  {
    /// Of the rectangle around the plate. [m]
    std::array<double, 2> side_lengths;

    double area; ///< [m^2]

    /// From the impact to the nearest edge, and along each axis, either way;
    /// negative for a point that is not on the plate. [m]
    double                distance_to_edge;
    std::array<double, 2> distance_along;

    /// Boundary ids of the edges and, from a file, their names.
    std::map<dealii::types::boundary_id, std::string> edges;

    /// Whether the plate mirrors in the line x = 0 and in y = 0 through the
    /// impact: what is meshed is then one side of it. A skew section mirrors in
    /// no line, and the mesh of a file is whole, whatever it is.
    std::array<bool, 2> is_symmetric = {};

    /// Where the part that is meshed begins and ends along each axis. [m]
    std::array<double, 2> begin = {}, end = {};

    /// Parts like the one that is meshed in the plate.
    double
    n_parts() const
    {
      return (is_symmetric[0] ? 2. : 1.) * (is_symmetric[1] ? 2. : 1.);
    }

    /// What holds each edge, by its boundary id.
    /// @param written  as in PlateParameters
    template <typename Support>
    std::map<dealii::types::boundary_id, Support>
    by_edge(const std::vector<OnEdge<Support>> &written) const
    {
      std::map<dealii::types::boundary_id, Support> result;
      for (const auto &[id, name] : edges)
        {
          // one word is for all edges, or the first for the first of two
          const OnEdge<Support> *one =
            &written[std::min(result.size(), written.size() - 1)];
          for (const OnEdge<Support> &named : written)
            if (!named.edge.empty() && named.edge == name)
              one = &named;
          result[id] = one->support;
        }
      return result;
    }
  };

  PlateGeometry
  geometry_of(const PlateParameters &plate);

  /// The first mesh, of the part that symmetry leaves, with boundary and
  /// manifold ids. Refinement keeps neighbours, across vertices too, within one
  /// level of each other: patches of the stress recovery then mix cells of
  /// similar size only.
  std::unique_ptr<dealii::Triangulation<2>>
  make_plate_mesh(const PlateParameters             &plate,
                  const std::array<unsigned int, 2> &n_cells);

  /// Longest side of its cells. [m]
  double
  initial_cell_size(const Parameters &parameters);

  /// The numbers of cells of the coarsest such mesh of a rectangle or circle
  /// that has none longer than that along its own two axes; on a circle along
  /// either, and by 2 % at most. [m]
  std::array<unsigned int, 2>
  n_cells_of_size(const PlateParameters &plate, std::array<double, 2> longest);

  /// The strength lambda of the singularity at a corner of a Reissner-Mindlin
  /// plate: near it the moments grow as r^{lambda - 1}, or the shear forces do
  /// where these grow faster. The rotations behave as the displacements of
  /// plane stress in a wedge whose sides are held (clamped), free (free and
  /// soft simply supported) or on rollers (simply supported); the deflection as
  /// that of a membrane (Williams, J. Appl. Mech. 19, 1952, p. 526;
  /// Burton & Sinclair, J. Appl. Mech. 53, 1986, p. 220).
  /// @param angle           between the two edges, inside the plate [rad]
  /// @param supports        of the two edges
  /// @param poissons_ratio  of the plate
  /// @return the smallest real part of an exponent between 0 and 1; 1 where
  ///         there is no singularity [-]
  double
  corner_strength(double                            angle,
                  const std::array<EdgeSupport, 2> &supports,
                  double                            poissons_ratio);

  /// The singular points that the mesh of a scene has, with the impact at the
  /// origin: those that the scene names or else, for the goal energy norm, the
  /// corners and changes of support of the outline, the ends of a line load and
  /// a point load. Corners of less than ten degrees between edges with one
  /// support are taken for a bend of a smooth edge. A laminate's exponents are
  /// those of an isotropic plate with a Poisson's ratio of 0.3.
  std::vector<SingularPoint>
  singular_points(const Parameters &parameters);
} // namespace PlateImpact
