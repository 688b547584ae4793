#include "plate_impact/plate/assumed_shear.h"

#include <deal.II/base/quadrature_lib.h>

namespace PlateImpact
{
  using namespace dealii;

  double
  lagrange(const Quadrature<1> &rule, const unsigned int i, const double x)
  {
    double value = 1.;
    for (unsigned int j = 0; j < rule.size(); ++j)
      if (j != i)
        value *= (x - rule.point(j)[0]) / (rule.point(i)[0] - rule.point(j)[0]);
    return value;
  }



  AssumedShear
  shear_at_gauss_points(const unsigned int n)
  {
    const auto interpolate = [n,
                              rule = QGauss<1>(n)](const CellOperator &tied,
                                                   const FEValues<2> &,
                                                   const FEValues<2> &values) {
      const unsigned int n_points = values.n_quadrature_points;
      CellOperator       result = CellOperator::Zero(2 * n_points, tied.cols());
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const Point<2> &p = values.get_quadrature().point(q);
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              result.middleRows<2>(2 * q) += lagrange(rule, i, p[0]) *
                lagrange(rule, j, p[1]) * tied.middleRows<2>(2 * (n * j + i));
        }
      return result;
    };
    return {QGauss<2>(n), interpolate};
  }



  std::vector<Point<2>>
  covariant_tying_points()
  {
    const QGauss<1>        linear(2);
    const QGaussLobatto<1> quadratic(3);
    std::vector<Point<2>>  points;
    for (const auto &part : {QAnisotropic<2>(linear, quadratic),
                             QAnisotropic<2>(quadratic, linear)})
      points.insert(points.end(),
                    part.get_points().begin(),
                    part.get_points().end());
    return points;
  }



  Eigen::Matrix<double, 2, 6>
  covariant_polynomials(const Point<2> &unit)
  {
    static const QGauss<1>        linear(2);
    static const QGaussLobatto<1> quadratic(3);
    Eigen::Matrix<double, 2, 6>   values;
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int i = 0; i < 2; ++i)
        {
          values(0, 2 * j + i) =
            lagrange(linear, i, unit[0]) * lagrange(quadratic, j, unit[1]);
          values(1, 3 * i + j) =
            lagrange(quadratic, j, unit[0]) * lagrange(linear, i, unit[1]);
        }
    return values;
  }



  AssumedShear
  mixed_shear()
  {
    using Row              = Eigen::RowVectorXd;
    const auto interpolate = [](const CellOperator &tied,
                                const FEValues<2>  &tying,
                                const FEValues<2>  &values) {
      // covariant component d x/d xi_a . gamma of a tying point
      const auto covariant = [&](const unsigned int t,
                                 const unsigned int a) -> Row {
        const auto &J = tying.jacobian(t);
        return J[0][a] * tied.row(2 * t) + J[1][a] * tied.row(2 * t + 1);
      };
      const unsigned int n      = values.n_quadrature_points;
      CellOperator       result = CellOperator::Zero(2 * n, tied.cols());
      for (unsigned int q = 0; q < n; ++q)
        {
          const auto polynomials =
            covariant_polynomials(values.get_quadrature().point(q));
          const auto &inverse = values.inverse_jacobian(q);
          for (const unsigned int a : {0, 1})
            {
              Row along = Row::Zero(tied.cols());
              for (unsigned int t = 0; t < 6; ++t)
                along += polynomials(a, t) * covariant(6 * a + t, a);
              for (unsigned int d = 0; d < 2; ++d)
                result.row(2 * q + d) += inverse[a][d] * along;
            }
        }
      return result;
    };
    return {Quadrature<2>(covariant_tying_points()), interpolate};
  }
} // namespace PlateImpact
