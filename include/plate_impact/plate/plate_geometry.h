#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/plate/plate_mesh.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What holds each edge of a mesh, by its boundary id.
  using SupportOfEdge = std::map<dealii::types::boundary_id, EdgeSupport>;

  /// What holds the middle surface of those that hold the deflection.
  using InPlaneSupportOfEdge =
    std::map<dealii::types::boundary_id, InPlaneSupport>;


  /// What follows from the outline of a plate and the place of the impact:
  /// lengths, symmetry, edges and the first mesh. One for each word of the
  /// entry Plate/Outline.
  class PlateGeometry
  {
  public:
    using CellNumbers = std::array<unsigned int, 2>; ///< along x and y

    /// @param plate  must outlive this object
    explicit PlateGeometry(const PlateParameters &plate)
      : plate(plate)
    {}

    virtual ~PlateGeometry() = default;

    /// Of the rectangle around the plate. [m]
    virtual double
    side_length(unsigned int d) const = 0;

    /// [m^2]
    virtual double
    area() const = 0;

    /// From the impact to the nearest edge; negative for a point that is not on
    /// the plate. [m]
    virtual double
    distance_to_edge() const = 0;

    /// The same along an axis, either way.
    virtual double
    distance_to_edge(unsigned int axis) const = 0;

    /// Whether the plate mirrors in the line x = 0 (d = 0) or y = 0 (d = 1)
    /// through the impact: what is meshed is then one side of it. A skew
    /// section mirrors in no line.
    virtual bool
    is_symmetric(unsigned int d) const;

    /// Parts like the one that is meshed in the plate.
    double
    n_parts() const;

    /// Where the part that is meshed begins and ends along an axis. [m]
    double
    begin(unsigned int d) const;
    double
    end(unsigned int d) const;

    /// Boundary ids of the edges and, from a file, their names.
    virtual std::map<dealii::types::boundary_id, std::string>
    edges() const = 0;

    /// What holds each of them.
    SupportOfEdge
    supports() const;

    /// What holds the middle surface there, where the deflection is held.
    InPlaneSupportOfEdge
    in_plane_supports() const;

    /// The part that symmetry leaves, with boundary and manifold ids.
    virtual void
    make_mesh(dealii::Triangulation<2> &mesh,
              const CellNumbers        &n_cells) const = 0;

    /// Cells of that mesh, about.
    virtual double
    n_initial_cells(const CellNumbers &n_cells) const;

    /// Longest side of its cells. [m]
    virtual double
    initial_cell_size(const CellNumbers &n_cells) const;

  protected:
    const PlateParameters &plate;

  private:
    template <typename Support>
    std::map<dealii::types::boundary_id, Support>
    by_edge(const std::vector<OnEdge<Support>> &written) const;
  };


  /// That of the plate's outline.
  /// @param plate  must outlive it
  std::unique_ptr<const PlateGeometry>
  geometry_of(const PlateParameters &plate);

  /// The first mesh. Refinement keeps neighbours, across vertices too, within
  /// one level of each other: patches of the stress recovery then mix cells of
  /// similar size only.
  std::unique_ptr<dealii::Triangulation<2>>
  make_plate_mesh(const PlateParameters             &plate,
                  const std::array<unsigned int, 2> &n_cells);

  /// Longest side of its cells. [m]
  double
  initial_cell_size(const Parameters &parameters);
} // namespace PlateImpact
