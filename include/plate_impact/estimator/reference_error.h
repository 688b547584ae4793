#pragma once

#include <deal.II/base/point.h>

#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>

#include <vector>

namespace PlateImpact
{
  /// Error of a transient in the energy norm against that on a much finer mesh,
  ///   int ||sigma_ref - sigma_h|| dt / int ||sigma_ref|| dt,
  /// what ErrorEstimate::eta estimates. Stress resultants are compared at the
  /// quadrature points of the fine mesh, wherever they fall in the other: there
  /// the resultants of the cell are interpolated between its own quadrature
  /// points, exactly on parallelograms. Needs no relation between the meshes.
  class ReferenceError
  {
  public:
    /// @param snapshots  of the fine mesh, the plate at rest before
    ReferenceError(const PlateDiscretization   &fine,
                   const std::vector<Snapshot> &snapshots);

    /// @param snapshots  at the times of those of the fine mesh
    double
    of(const PlateDiscretization   &discretization,
       const std::vector<Snapshot> &snapshots) const;

  private:
    std::vector<dealii::Point<2>> points;
    std::vector<double>           weights; ///< [m^2]
    Eigen::MatrixXd               exact;   ///< 5 point + resultant by times
    std::vector<double>           times;   ///< [s]
  };
} // namespace PlateImpact
