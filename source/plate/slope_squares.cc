#include "plate_impact/plate/slope_squares.h"

#include <deal.II/base/quadrature_lib.h>

#include "plate_impact/plate/assumed_shear.h"

#include <vector>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    // Tying points of the strains along xi, along eta and of shear; slopes are
    // in this order too, along eta at the last points once more.
    constexpr int n_along = 6, n_shear = 4;

    const QGauss<1> &
    linear_points()
    {
      static const QGauss<1> points(2);
      return points;
    }

    const QGaussLobatto<1> &
    quadratic_points()
    {
      static const QGaussLobatto<1> points(3);
      return points;
    }
  } // namespace



  const Eigen::MatrixXd &
  SlopeSquares::slopes()
  {
    static const Eigen::MatrixXd result = [] {
      const FE_Q<2>         element(2);
      std::vector<Point<2>> points;
      for (const auto &part :
           {QAnisotropic<2>(linear_points(), quadratic_points()),
            QAnisotropic<2>(quadratic_points(), linear_points()),
            QAnisotropic<2>(linear_points(), linear_points()),
            QAnisotropic<2>(linear_points(), linear_points())})
        points.insert(points.end(),
                      part.get_points().begin(),
                      part.get_points().end());
      Eigen::MatrixXd slopes(n_slopes, element.n_dofs_per_cell());
      for (int t = 0; t < n_slopes; ++t)
        {
          const bool is_along_eta =
            (t >= n_along && t < 2 * n_along) || t >= 2 * n_along + n_shear;
          for (unsigned int node = 0; node < element.n_dofs_per_cell(); ++node)
            slopes(t, node) =
              element.shape_grad(node, points[t])[is_along_eta ? 1 : 0];
        }
      return slopes;
    }();
    return result;
  }



  Eigen::VectorXd
  SlopeSquares::squares(const Eigen::Ref<const Eigen::VectorXd> &slopes)
  {
    Eigen::VectorXd result(n_squares);
    result.head<2 * n_along>() = 0.5 * slopes.head<2 * n_along>().cwiseAbs2();
    result.tail<n_shear>() =
      slopes.segment<n_shear>(2 * n_along).cwiseProduct(slopes.tail<n_shear>());
    return result;
  }



  Eigen::VectorXd
  SlopeSquares::forces(const Eigen::Ref<const Eigen::VectorXd> &s,
                       const Eigen::Ref<const Eigen::VectorXd> &of_squares)
  {
    Eigen::VectorXd of_slopes(n_slopes);
    of_slopes.head<2 * n_along>() =
      s.head<2 * n_along>().cwiseProduct(of_squares.head<2 * n_along>());
    of_slopes.segment<n_shear>(2 * n_along) =
      s.tail<n_shear>().cwiseProduct(of_squares.tail<n_shear>());
    of_slopes.tail<n_shear>() =
      s.segment<n_shear>(2 * n_along).cwiseProduct(of_squares.tail<n_shear>());
    return slopes().transpose() * of_slopes;
  }



  Eigen::MatrixXd
  SlopeSquares::derivative(const Eigen::Ref<const Eigen::VectorXd> &s)
  {
    const Eigen::MatrixXd &by_node = slopes();
    Eigen::MatrixXd        result(n_squares, by_node.cols());
    result.topRows<2 * n_along>() =
      s.head<2 * n_along>().asDiagonal() * by_node.topRows<2 * n_along>();
    result.bottomRows<n_shear>() = s.tail<n_shear>().asDiagonal() *
        by_node.middleRows<n_shear>(2 * n_along) +
      s.segment<n_shear>(2 * n_along).asDiagonal() *
        by_node.bottomRows<n_shear>();
    return result;
  }



  Eigen::MatrixXd
  SlopeSquares::second_derivative(
    const Eigen::Ref<const Eigen::VectorXd> &forces)
  {
    const Eigen::MatrixXd &by_node = slopes();
    const auto             along   = by_node.topRows<2 * n_along>();
    const Eigen::MatrixXd of_shear = by_node.bottomRows<n_shear>().transpose() *
      forces.tail<n_shear>().asDiagonal() *
      by_node.middleRows<n_shear>(2 * n_along);
    return along.transpose() * forces.head<2 * n_along>().asDiagonal() * along +
      of_shear + of_shear.transpose();
  }



  Eigen::MatrixXd
  SlopeSquares::strains(const FEValues<2> &values)
  {
    const auto        &linear    = linear_points();
    const auto        &quadratic = quadratic_points();
    const unsigned int n         = values.n_quadrature_points;
    Eigen::MatrixXd    result(3 * n, n_squares);
    for (unsigned int q = 0; q < n; ++q)
      {
        // covariant components at the point
        const Point<2> &p = values.get_quadrature().point(q);
        Eigen::Matrix<double, 3, n_squares> at_point;
        at_point.setZero();
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int i = 0; i < 2; ++i)
            {
              at_point(0, 2 * j + i) =
                lagrange(linear, i, p[0]) * lagrange(quadratic, j, p[1]);
              at_point(1, n_along + 3 * i + j) =
                lagrange(quadratic, j, p[0]) * lagrange(linear, i, p[1]);
            }
        for (unsigned int j = 0; j < 2; ++j)
          for (unsigned int i = 0; i < 2; ++i)
            at_point(2, 2 * n_along + 2 * j + i) =
              lagrange(linear, i, p[0]) * lagrange(linear, j, p[1]);
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
