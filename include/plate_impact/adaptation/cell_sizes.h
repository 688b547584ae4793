#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/estimator/error_estimator.h"

#include <vector>

namespace PlateImpact
{
  /// Sizes that follow from the error of each cell (Table 1 of the paper),
  /// h_new = h / xi'^phi with phi = size_exponent(), infinite without an error.
  /// By active index. Whether a cell is coarsened is decided on these, its size
  /// by allowed_size(). [m]
  std::vector<double>
  target_sizes(const dealii::Triangulation<2> &mesh,
               const ErrorRatios              &error,
               const AdaptivityParameters     &adaptivity);

  /// The strongest of the singular points that a cell touches, or null.
  const SingularPoint *
  singular_point_of(const dealii::Triangulation<2>::cell_iterator &cell,
                    const AdaptivityParameters                    &adaptivity);

  /// phi of a cell: that of the scene, 1/p, or 1/lambda in a cell that touches
  /// a singular point of strength lambda, whose error falls with h^lambda
  /// (Table 1 of the paper; Zienkiewicz & Zhu 1987, doi:10.1002/nme.1620240206)
  /// and four at most.
  double
  size_exponent(const dealii::Triangulation<2>::cell_iterator &cell,
                const AdaptivityParameters                    &adaptivity);

  /// The size at a place in a cell which needs the given one: the same, but
  /// where it touches a singular point growing with the distance from that, so
  /// that new cells have errors alike. [m]
  double
  size_at(const dealii::Point<2>                        &position,
          double                                         size,
          const dealii::Triangulation<2>::cell_iterator &cell,
          const AdaptivityParameters                    &adaptivity);

  /// Of the scene; where the program has chosen it, for the load, a millionth
  /// of it at other singular points. [m]
  double
  minimum_cell_size(const dealii::Triangulation<2>::cell_iterator &cell,
                    const AdaptivityParameters                    &adaptivity);

  /// The size nearest to one that is wanted, between the minimum and the
  /// maximum cell size; where the minimum is the larger one, the maximum. [m]
  double
  allowed_size(double                                         size,
               const dealii::Triangulation<2>::cell_iterator &cell,
               const AdaptivityParameters                    &adaptivity);

  /// About how many cells have the area of the mesh when each gives way to
  /// cells of the allowed size next to its target, by active index [m].
  double
  n_cells_of_sizes(const dealii::Triangulation<2> &mesh,
                   const std::vector<double>      &sizes,
                   const AdaptivityParameters     &adaptivity);

  /// Whether the minimum cell size forbids to refine a cell.
  bool
  is_smallest(const dealii::Triangulation<2>::cell_iterator &cell,
              const AdaptivityParameters                    &adaptivity);
} // namespace PlateImpact
