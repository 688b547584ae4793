#pragma once

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Core>

namespace PlateImpact
{
  /// The strains of the middle surface that slopes of the deflection cause, (
  /// w_x^2/2, w_y^2/2, w_x w_y ) after von Karman, as a cell assumes them.
  ///
  /// Squares of slopes are of higher order than the strains of displacements in
  /// the plane: taken as they are, these cannot balance them, and the membrane
  /// locks. So they are tied where those strains have their degree, as the
  /// transverse shear of MITC9: covariant components at
  /// covariant_tying_points(), that of shear at 2x2 Gauss points. On
  /// parallelograms a plate of nine nodes then bends without a membrane force
  /// where the exact one does.
  class SlopeSquares
  {
  public:
    static constexpr int n_squares = 16;

    /// Slopes of the deflection at the tying points, along xi and eta of the
    /// reference cell, from its values at nine nodes: 2 n_squares x 9. Strain k
    /// is the product of slopes k and n_squares + k, the first of which is
    /// halved where both are the same. The same for every cell.
    static const Eigen::MatrixXd &
    slopes();

    /// The covariant strains, from slopes.
    static Eigen::VectorXd
    squares(const Eigen::Ref<const Eigen::VectorXd> &slopes);

    /// Their derivative with respect to the nine deflections.
    static Eigen::MatrixXd
    derivative(const Eigen::Ref<const Eigen::VectorXd> &slopes);

    /// Second derivative of forces . squares with respect to the deflections.
    static Eigen::MatrixXd
    second_derivative(const Eigen::Ref<const Eigen::VectorXd> &forces);

    /// Strains at points of a cell, three rows each, from the covariant ones:
    /// 3 n x n_squares.
    /// @param values  FEValues there, with inverse Jacobians
    static Eigen::MatrixXd
    strains(const dealii::FEValues<2> &values);
  };
} // namespace PlateImpact
