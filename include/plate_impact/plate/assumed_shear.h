#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace PlateImpact
{
  /// Lagrange polynomial of the points of a rule that is 1 at point i.
  double
  lagrange(const dealii::Quadrature<1> &rule, unsigned int i, double x);


  /// Rows: numbers for each of some points of a cell, point by point. Columns:
  /// the unknowns of the cell in the order of the finite element.
  using CellOperator = Eigen::MatrixXd;


  /// The transverse shear strain that an element assumes in place of the one
  /// that follows from deflection and rotations, which locks on thin plates: it
  /// is tied to the latter at some points of the cell and interpolated between
  /// them.
  struct AssumedShear
  {
    /// Where the strain is tied, on the reference cell.
    dealii::Quadrature<2> tying_points;

    /// The assumed strain, two Cartesian components a point.
    /// @param tied    strains from deflection and rotations at the tying points
    /// @param tying   FEValues there, with Jacobians
    /// @param values  FEValues at the points of the result, with inverse
    /// Jacobians
    std::function<CellOperator(const CellOperator        &tied,
                               const dealii::FEValues<2> &tying,
                               const dealii::FEValues<2> &values)>
      interpolate;
  };


  /// Tied at n x n Gauss points, Cartesian components interpolated by
  /// polynomials of degree n - 1 in each direction: the same as integrating the
  /// shear energy with these points only (Malkus & Hughes, Comput Methods Appl
  /// Mech Engng 15, 1978, 63-81), since they integrate the square of such a
  /// strain exactly on parallelograms. As the rest of the element has 3 x 3
  /// points, nothing is assumed with n = 3.
  AssumedShear
  shear_at_gauss_points(unsigned int n);


  /// Where covariant components are tied: the six points of that along xi, at
  /// xi = +-1/sqrt(3), eta = -1, 0, 1, then the six of that along eta, the
  /// other way round; in both xi runs fastest.
  std::vector<dealii::Point<2>>
  covariant_tying_points();

  /// The polynomials between them, of the component along xi (row 0) and along
  /// eta (row 1), at a point of the reference cell.
  Eigen::Matrix<double, 2, 6>
  covariant_polynomials(const dealii::Point<2> &unit);


  /// Mixed interpolation of tensorial components with nine nodes, after Bucalem
  /// & Bathe (Int J Numer Meth Engng 36, 1993, 3729-3754), tied at
  /// covariant_tying_points(): the covariant component along xi is linear in xi
  /// and quadratic in eta, that along eta the other way round.
  ///
  /// The outer points lie on the edges, where the edge tying of the plate
  /// elements of Bathe, Brezzi & Cho (Comput Struct 32, 1989, 797-814) has
  /// them, and not at eta = +-sqrt(3/5): the strain along an edge is then the
  /// same in both cells that share it. On squares the two agree; on distorted
  /// cells the inner points lock (measured, clamped plate with 8x8 cells moved
  /// by a quarter of their size: 0.94, 0.64 and 0.08 of the thin plate's
  /// deflection at a/t = 1e4, 1e5, 1e6; on the edges 1.000 at all three).
  AssumedShear
  mixed_shear();
} // namespace PlateImpact
