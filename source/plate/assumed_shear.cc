#include "plate_impact/plate/assumed_shear.h"

#include <deal.II/base/quadrature_lib.h>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Lagrange polynomial of the points of a rule that is 1 at point i.
    double
    lagrange(const Quadrature<1> &rule, const unsigned int i, const double x)
    {
      double value = 1.;
      for (unsigned int j = 0; j < rule.size(); ++j)
        if (j != i)
          value *=
            (x - rule.point(j)[0]) / (rule.point(i)[0] - rule.point(j)[0]);
      return value;
    }



    /// Tensor product of a rule in xi and one in eta, xi running fastest.
    std::vector<Point<2>>
    tensor_points(const Quadrature<1> &xi, const Quadrature<1> &eta)
    {
      std::vector<Point<2>> points;
      for (const Point<1> &y : eta.get_points())
        for (const Point<1> &x : xi.get_points())
          points.emplace_back(x[0], y[0]);
      return points;
    }



    std::vector<Point<2>>
    joined(std::vector<Point<2>> points, const std::vector<Point<2>> &more)
    {
      points.insert(points.end(), more.begin(), more.end());
      return points;
    }
  } // namespace



  ShearAtGaussPoints::ShearAtGaussPoints(const unsigned int n)
    : rule(n)
    , points(tensor_points(rule, rule))
  {}



  const Quadrature<2> &
  ShearAtGaussPoints::tying_points() const
  {
    return points;
  }



  CellOperator
  ShearAtGaussPoints::interpolate(const CellOperator &tied,
                                  const FEValues<2> &,
                                  const FEValues<2> &values) const
  {
    const unsigned int n      = values.n_quadrature_points;
    CellOperator       result = CellOperator::Zero(2 * n, n_cell_dofs);
    for (unsigned int q = 0; q < n; ++q)
      {
        const Point<2> &p = values.get_quadrature().point(q);
        for (unsigned int j = 0; j < rule.size(); ++j)
          for (unsigned int i = 0; i < rule.size(); ++i)
            result.middleRows<2>(2 * q) += lagrange(rule, i, p[0]) *
              lagrange(rule, j, p[1]) *
              tied.middleRows<2>(2 * (rule.size() * j + i));
      }
    return result;
  }



  ReducedShear::ReducedShear()
    : ShearAtGaussPoints(2)
  {}



  FullShear::FullShear()
    : ShearAtGaussPoints(3)
  {}



  MixedShear::MixedShear()
    : points(joined(tensor_points(QGauss<1>(2), QGaussLobatto<1>(3)),
                    tensor_points(QGaussLobatto<1>(3), QGauss<1>(2))))
  {}



  const Quadrature<2> &
  MixedShear::tying_points() const
  {
    return points;
  }



  CellOperator
  MixedShear::interpolate(const CellOperator &tied,
                          const FEValues<2>  &tying,
                          const FEValues<2>  &values) const
  {
    using Row = Eigen::Matrix<double, 1, n_cell_dofs>;

    // covariant component d x/d xi_a . gamma of a tying point
    const auto covariant = [&](const unsigned int t,
                               const unsigned int a) -> Row {
      const auto &J = tying.jacobian(t);
      return J[0][a] * tied.row(2 * t) + J[1][a] * tied.row(2 * t + 1);
    };

    const QGauss<1>        linear(2);
    const QGaussLobatto<1> quadratic(3);
    const unsigned int     n      = values.n_quadrature_points;
    CellOperator           result = CellOperator::Zero(2 * n, n_cell_dofs);
    for (unsigned int q = 0; q < n; ++q)
      {
        const Point<2> &p        = values.get_quadrature().point(q);
        Row             along[2] = {Row::Zero(), Row::Zero()};
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int i = 0; i < 2; ++i)
            {
              along[0] += lagrange(linear, i, p[0]) *
                lagrange(quadratic, j, p[1]) * covariant(2 * j + i, 0);
              along[1] += lagrange(quadratic, j, p[0]) *
                lagrange(linear, i, p[1]) * covariant(6 + 3 * i + j, 1);
            }
        const auto &inverse = values.inverse_jacobian(q);
        for (unsigned int d = 0; d < 2; ++d)
          result.row(2 * q + d) =
            inverse[0][d] * along[0] + inverse[1][d] * along[1];
      }
    return result;
  }
} // namespace PlateImpact
