#include "plate_impact/plate/slope_squares.h"

#include <deal.II/base/quadrature_lib.h>

#include "plate_impact/plate/assumed_shear.h"

#include <vector>

namespace PlateImpact
{
  using namespace dealii;

  const Eigen::MatrixXd &
  SlopeSquares::slopes()
  {
    static const Eigen::MatrixXd result = [] {
      const FE_Q<2>         element(2);
      const QGauss<2>       of_shear(2);
      std::vector<Point<2>> points = covariant_tying_points();
      points.insert(points.end(),
                    of_shear.get_points().begin(),
                    of_shear.get_points().end());
      // six of the strain along xi, six of that along eta, four of shear
      Eigen::MatrixXd slopes(2 * n_squares, element.n_dofs_per_cell());
      for (int t = 0; t < n_squares; ++t)
        for (unsigned int node = 0; node < element.n_dofs_per_cell(); ++node)
          {
            const Tensor<1, 2> slope    = element.shape_grad(node, points[t]);
            const double       second   = slope[t < 6 ? 0 : 1];
            slopes(t, node)             = t < 12 ? 0.5 * second : slope[0];
            slopes(n_squares + t, node) = second;
          }
      return slopes;
    }();
    return result;
  }



  Eigen::VectorXd
  SlopeSquares::squares(const Eigen::Ref<const Eigen::VectorXd> &s)
  {
    return s.head<n_squares>().cwiseProduct(s.tail<n_squares>());
  }



  Eigen::MatrixXd
  SlopeSquares::derivative(const Eigen::Ref<const Eigen::VectorXd> &s)
  {
    return s.tail<n_squares>().asDiagonal() * slopes().topRows<n_squares>() +
      s.head<n_squares>().asDiagonal() * slopes().bottomRows<n_squares>();
  }



  Eigen::MatrixXd
  SlopeSquares::second_derivative(
    const Eigen::Ref<const Eigen::VectorXd> &forces)
  {
    const Eigen::MatrixXd result = slopes().topRows<n_squares>().transpose() *
      forces.asDiagonal() * slopes().bottomRows<n_squares>();
    return result + result.transpose();
  }



  Eigen::MatrixXd
  SlopeSquares::strains(const FEValues<2> &values)
  {
    const QGauss<1>    gauss(2);
    const unsigned int n = values.n_quadrature_points;
    Eigen::MatrixXd    result(3 * n, n_squares);
    for (unsigned int q = 0; q < n; ++q)
      {
        // covariant components at the point
        const Point<2> &p = values.get_quadrature().point(q);
        Eigen::Matrix<double, 3, n_squares> at_point;
        at_point.setZero();
        const auto along           = covariant_polynomials(p);
        at_point.block<1, 6>(0, 0) = along.row(0);
        at_point.block<1, 6>(1, 6) = along.row(1);
        for (unsigned int j = 0; j < 2; ++j)
          for (unsigned int i = 0; i < 2; ++i)
            at_point(2, 12 + 2 * j + i) =
              lagrange(gauss, i, p[0]) * lagrange(gauss, j, p[1]);
        // d xi_a / d x_d turns them into Cartesian ones
        const auto     &xi = values.inverse_jacobian(q);
        Eigen::Matrix3d turned;
        for (unsigned int d = 0; d < 2; ++d)
          turned.row(d) << xi[0][d] * xi[0][d], xi[1][d] * xi[1][d],
            xi[0][d] * xi[1][d];
        turned.row(2) << 2. * xi[0][0] * xi[0][1], 2. * xi[1][0] * xi[1][1],
          xi[0][0] * xi[1][1] + xi[1][0] * xi[0][1];
        result.middleRows<3>(3 * q) = turned * at_point;
      }
    return result;
  }
} // namespace PlateImpact
