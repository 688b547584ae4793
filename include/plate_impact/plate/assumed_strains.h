#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Core>

#include <functional>

/// Strains that an element assumes in place of those that follow from its
/// unknowns, which lock: they are tied to the latter at some points of the cell
/// and interpolated between them.
namespace PlateImpact
{
  /// Rows: numbers for each of some points of a cell, point by point. Columns:
  /// the unknowns of the cell in the order of the finite element.
  using CellOperator = Eigen::MatrixXd;


  /// The transverse shear strain.
  struct AssumedShear
  {
    /// Where the strain is tied, on the reference cell.
    dealii::Quadrature<2> tying_points;

    /// The assumed strain: of all points the component along x, then that
    /// along y.
    /// @param tied    the same from deflection and rotations at tying points
    /// @param tying   FEValues there, with Jacobians
    /// @param values  FEValues at the points of the result, with inverse
    /// Jacobians
    std::function<CellOperator(const CellOperator        &tied,
                               const dealii::FEValues<2> &tying,
                               const dealii::FEValues<2> &values)>
      interpolate;
  };


  /// Tied at n x n Gauss points, Cartesian components interpolated by
  /// polynomials of degree n - 1 in each direction: on parallelograms the same
  /// as integrating the shear energy with these points only (Malkus & Hughes,
  /// Comput Methods Appl Mech Engng 15, 1978, 63-81). As the rest of the
  /// element has 3 x 3 points, nothing is assumed with n = 3.
  AssumedShear
  shear_at_gauss_points(unsigned int n);


  /// Mixed interpolation of tensorial components with nine nodes, after Bucalem
  /// & Bathe (Int J Numer Meth Engng 36, 1993, 3729-3754): the covariant
  /// component along xi is linear in xi and quadratic in eta, tied at xi =
  /// +-1/sqrt(3), eta = -1, 0, 1, that along eta the other way round.
  ///
  /// The outer points lie on the edges, as those of Bathe, Brezzi & Cho (Comput
  /// Struct 32, 1989, 797-814), and not at eta = +-sqrt(3/5): the strain along
  /// an edge is then the same in both of its cells. On squares the two agree;
  /// on distorted cells the inner points lock (clamped plate, 8x8 cells moved
  /// by a quarter of their size: 0.08 of the thin plate's deflection at a/t =
  /// 1e6, on the edges 1.000).
  AssumedShear
  mixed_shear();


  /// The strains of the middle surface that slopes of the deflection cause, (
  /// w_x^2/2, w_y^2/2, w_x w_y ) after von Karman, as a cell assumes them.
  ///
  /// Squares of slopes are of higher order than the strains of displacements in
  /// the plane, which cannot balance them: the membrane locks. So they are tied
  /// where those have their degree: covariant components as in mixed_shear(),
  /// that of shear at 2x2 Gauss points. On parallelograms a plate of nine nodes
  /// then bends without a membrane force where the exact one does.
  namespace SlopeSquares
  {
    constexpr int n_squares = 16;

    /// Slopes of the deflection at the tying points, along xi and eta of the
    /// reference cell, from its values at nine nodes: 2 n_squares x 9. Strain k
    /// is the product of slopes k and n_squares + k, the first of which is
    /// halved where both are the same. The same for every cell.
    const Eigen::MatrixXd &
    slopes();

    /// The covariant strains, from slopes, a column per state or cell.
    inline Eigen::MatrixXd
    squares(const Eigen::MatrixXd &slopes)
    {
      return slopes.topRows<n_squares>().cwiseProduct(
        slopes.bottomRows<n_squares>());
    }

    /// Strains at points of a cell, three rows each, from the covariant ones:
    /// 3 n x n_squares.
    /// @param values  FEValues there, with inverse Jacobians
    Eigen::MatrixXd
    strains(const dealii::FEValues<2> &values);
  } // namespace SlopeSquares
} // namespace PlateImpact
