#pragma once

#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <optional>

namespace PlateImpact
{
  /// What a mesh's matrices have too little or too much of, for every pair of
  /// motions.
  struct MissedByMesh
  {
    /// Motions Z, states of the plate, a column each.
    Eigen::MatrixXd motions;
    /// E, by which the strain energies Z^T K Z are too large. [J]
    Eigen::MatrixXd energies;
    /// G, by which Z^T M Z is larger than the mass of these motions,
    /// PlateElement::wave_mass(). [kg m^2]
    Eigen::MatrixXd masses;
  };


  /// A linear plate that is softer and lighter along some of its motions Z. Its
  /// compliance is K^-1 + Z S^-1 E S^-1 Z^T with S = Z^T K Z, so that the
  /// strain energies of pairs of motions, S, become S - E to first order in E;
  /// where a mesh misses as much as it has, E = S, half of the stiffness is
  /// left. Its mass is M - M Z m^-1 G m^-1 Z^T M with m = Z^T M Z, so that m
  /// becomes m - G. With what a mesh misses, it is the plate of a finer mesh,
  /// as far as one mesh can tell. By Sherman, Morrison and Woodbury a step
  /// costs as much as one of the plate, two products with a vector per motion
  /// and two with two.
  class SoftenedSystem : public SemidiscreteSystem
  {
  public:
    /// @param plate   must outlive the system
    /// @param missed  symmetric and not negative, by their lower triangles
    SoftenedSystem(SemidiscreteSystem &plate, const MissedByMesh &missed);

    void
    multiply_stiffness(const Eigen::VectorXd &x,
                       Eigen::VectorXd       &y) const override
    {
      plate.multiply_stiffness(x, y);
      y -= lost_stiffness * (lost_stiffness.transpose() * x);
    }

    void
    multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const override
    {
      plate.multiply_mass(x, y);
      y -= lost_mass * (lost_mass.transpose() * x);
    }

    void
    solve(double c, const Eigen::VectorXd &b, Eigen::VectorXd &x) override;

  private:
    SemidiscreteSystem   &plate;
    Eigen::MatrixXd       lost_stiffness; ///< K of the plate loses L L^T
    Eigen::MatrixXd       lost_mass;      ///< M loses W W^T
    std::optional<double> factorized_for; ///< c [1/s^2]
    Eigen::MatrixXd       lost;           ///< B = (L, c^1/2 W)
    Eigen::MatrixXd       responses;      ///< (K + c M)^-1 B of the plate
    Eigen::MatrixXd       inverse;        ///< of I - B^T (K + c M)^-1 B
  };
} // namespace PlateImpact
