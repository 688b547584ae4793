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

      /// The polynomials at the points of the values, a row each.
      Eigen::MatrixXd
      at(const FEValues<2> &values) const
      {
        Eigen::MatrixXd result(values.n_quadrature_points, points.size());
        for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
          for (unsigned int t = 0; t < points.size(); ++t)
            result(q, t) =
              polynomials.compute_value(t, values.get_quadrature().point(q));
        return result;
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
      const Eigen::MatrixXd polynomials = gauss.at(values);
      const unsigned int    n           = gauss.points.size();
      CellOperator          result(2 * polynomials.rows(), tied.cols());
      result << polynomials * tied.topRows(n), polynomials * tied.bottomRows(n);
      return result;
    };
    return {gauss.points, interpolate};
  }



  AssumedShear
  mixed_shear()
  {
    const auto interpolate = [](const CellOperator &tied,
                                const FEValues<2>  &tying,
                                const FEValues<2>  &values) {
      const unsigned int n      = values.n_quadrature_points;
      CellOperator       result = CellOperator::Zero(2 * n, tied.cols());
      for (const unsigned int a : {0, 1})
        {
          // covariant component d x/d xi_a . gamma of the tying points
          CellOperator covariant(6, tied.cols());
          for (unsigned int t = 0; t < 6; ++t)
            {
              const unsigned int point = 6 * a + t;
              const auto        &J     = tying.jacobian(point);
              covariant.row(t) =
                J[0][a] * tied.row(point) + J[1][a] * tied.row(12 + point);
            }
          const CellOperator along =
            covariant_components()[a].at(values) * covariant;
          for (unsigned int q = 0; q < n; ++q)
            for (unsigned int d = 0; d < 2; ++d)
              result.row(d * n + q) +=
                values.inverse_jacobian(q)[a][d] * along.row(q);
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
                const Tensor<1, 2> slope = element.shape_grad(node, point);
                slopes(k, node) =
                  (component == 2 ? 1. : 0.5) * slope[component == 1];
                slopes(n_squares + k, node) = slope[component != 0];
              }
            ++k;
          }
      return slopes;
    }();
    return result;
  }



  Eigen::MatrixXd
  SlopeSquares::strains(const FEValues<2> &values)
  {
    Eigen::MatrixXd result(3 * values.n_quadrature_points, n_squares);
    for (const unsigned int component : {0, 1, 2})
      {
        const Eigen::MatrixXd polynomials =
          covariant_components()[component].at(values);
        for (unsigned int q = 0; q < polynomials.rows(); ++q)
          {
            // d xi_a / d x_d turns them into Cartesian ones
            const auto &xi = values.inverse_jacobian(q);
            const auto  a = xi[component == 1], b = xi[component != 0];
            const Eigen::Vector3d turned(a[0] * b[0],
                                         a[1] * b[1],
                                         a[0] * b[1] + a[1] * b[0]);
            result.block(3 * q, 6 * component, 3, polynomials.cols()) =
              turned * polynomials.row(q);
          }
      }
    return result;
  }
} // namespace PlateImpact
