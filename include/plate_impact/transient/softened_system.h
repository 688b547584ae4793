#pragma once

#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <optional>

namespace PlateImpact
{
  /// A linear plate that is softer along some of its motions Z: its compliance
  /// is K^-1 + Z S^-1 E S^-1 Z^T with S = Z^T K Z, so that the strain energies
  /// of pairs of motions, S, become S - E to first order in E. With E the
  /// energies of what a mesh misses, it is the plate of a finer mesh, as far as
  /// one mesh can tell; where it misses as much as it has, E = S, half of the
  /// stiffness is left. By Sherman, Morrison and Woodbury a step costs as much
  /// as one of the plate and four products with a vector per motion.
  class SoftenedSystem : public SemidiscreteSystem
  {
  public:
    /// @param plate    must outlive the system
    /// @param motions  Z, states of the plate, a column each
    /// @param missed   E, symmetric and not negative; a row and a column per
    ///                 motion
    SoftenedSystem(SemidiscreteSystem    &plate,
                   const Eigen::MatrixXd &motions,
                   const Eigen::MatrixXd &missed);

    void
    multiply_stiffness(const Eigen::VectorXd &x,
                       Eigen::VectorXd       &y) const override
    {
      plate.multiply_stiffness(x, y);
      y -= lost * (lost.transpose() * x);
    }

    void
    solve(double c, const Eigen::VectorXd &b, Eigen::VectorXd &x) override;

  private:
    SemidiscreteSystem   &plate;
    Eigen::MatrixXd       lost;           ///< L, K of the plate loses L L^T
    std::optional<double> factorized_for; ///< c [1/s^2]
    Eigen::MatrixXd       responses;      ///< (K + c M)^-1 L of the plate
    Eigen::MatrixXd       inverse;        ///< of I - L^T (K + c M)^-1 L
  };
} // namespace PlateImpact
