#include "plate_impact/plate/assumed_strains.h"

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor_product_polynomials.h>
#include <deal.II/fe/fe_q.h>

#include <array>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Points where a component is tied, and the polynomials between them; of
    /// both xi runs fastest.
    struct TyingPoints
    {
      TyingPoints(const Quadrature<1> &xi, const Quadrature<1> &eta)
        : points(QAnisotropic<2>(xi, eta))
        , polynomials(
            {Polynomials::generate_complete_Lagrange_basis(xi.get_points()),
             Polynomials::generate_complete_Lagrange_basis(eta.get_points())})
      {}

      /// The polynomials at a point of the reference cell.
      Eigen::RowVectorXd
      at(const Point<2> &unit) const
      {
        Eigen::RowVectorXd values(points.size());
        for (unsigned int t = 0; t < points.size(); ++t)
          values[t] = polynomials.compute_value(t, unit);
        return values;
      }

      Quadrature<2>             points;
      AnisotropicPolynomials<2> polynomials;
    };



    /// Of the covariant components along xi, along eta, and of shear.
    const std::array<TyingPoints, 3> &
    covariant_components()
    {
      const QGauss<1>                         linear(2);
      const QGaussLobatto<1>                  quadratic(3);
      static const std::array<TyingPoints, 3> components = {
        {{linear, quadratic}, {quadratic, linear}, {linear, linear}}};
      return components;
    }
  } // namespace



  AssumedShear
  shear_at_gauss_points(const unsigned int n)
  {
    const TyingPoints gauss{QGauss<1>(n), QGauss<1>(n)};
    const auto        interpolate = [gauss](const CellOperator &tied,
                                     const FEValues<2> &,
                                     const FEValues<2> &values) {
      const unsigned int n_points = values.n_quadrature_points;
      CellOperator       result = CellOperator::Zero(2 * n_points, tied.cols());
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const auto polynomials = gauss.at(values.get_quadrature().point(q));
          for (unsigned int t = 0; t < gauss.points.size(); ++t)
            result.middleRows<2>(2 * q) +=
              polynomials[t] * tied.middleRows<2>(2 * t);
        }
      return result;
    };
    return {gauss.points, interpolate};
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
        for (const unsigned int a : {0, 1})
          {
            const Row polynomials =
              covariant_components()[a].at(values.get_quadrature().point(q));
            Row along = Row::Zero(tied.cols());
            for (unsigned int t = 0; t < 6; ++t)
              along += polynomials[t] * covariant(6 * a + t, a);
            for (unsigned int d = 0; d < 2; ++d)
              result.row(2 * q + d) += values.inverse_jacobian(q)[a][d] * along;
          }
      return result;
    };
    const auto           &components = covariant_components();
    std::vector<Point<2>> points     = components[0].points.get_points();
    for (const Point<2> &point : components[1].points.get_points())
      points.push_back(point);
    return {Quadrature<2>(points), interpolate};
  }



  const Eigen::MatrixXd &
  SlopeSquares::slopes()
  {
    static const Eigen::MatrixXd result = [] {
      const FE_Q<2>   element(2);
      Eigen::MatrixXd slopes(2 * n_squares, element.n_dofs_per_cell());
      int             k = 0;
      for (const unsigned int component : {0, 1, 2})
        for (const Point<2> &point :
             covariant_components()[component].points.get_points())
          {
            for (unsigned int node = 0; node < slopes.cols(); ++node)
              {
                const Tensor<1, 2> slope  = element.shape_grad(node, point);
                const double       second = slope[component == 0 ? 0 : 1];
                slopes(k, node) = component == 2 ? slope[0] : 0.5 * second;
                slopes(n_squares + k, node) = second;
              }
            ++k;
          }
      return slopes;
    }();
    return result;
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
    const unsigned int n = values.n_quadrature_points;
    Eigen::MatrixXd    result(3 * n, n_squares);
    for (unsigned int q = 0; q < n; ++q)
      {
        Eigen::MatrixXd covariant = Eigen::MatrixXd::Zero(3, n_squares);
        for (const int component : {0, 1, 2})
          {
            const auto polynomials = covariant_components()[component].at(
              values.get_quadrature().point(q));
            covariant.row(component).segment(6 * component,
                                             polynomials.size()) = polynomials;
          }
        // d xi_a / d x_d turns them into Cartesian ones
        const auto     &xi = values.inverse_jacobian(q);
        Eigen::Matrix3d turned;
        for (unsigned int d = 0; d < 2; ++d)
          turned.row(d) << xi[0][d] * xi[0][d], xi[1][d] * xi[1][d],
            xi[0][d] * xi[1][d];
        turned.row(2) << 2. * xi[0][0] * xi[0][1], 2. * xi[1][0] * xi[1][1],
          xi[0][0] * xi[1][1] + xi[1][0] * xi[0][1];
        result.middleRows<3>(3 * q) = turned * covariant;
      }
    return result;
  }
} // namespace PlateImpact
