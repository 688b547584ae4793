#include "plate_impact/estimator/reference_error.h"

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/grid_tools_cache.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/plate_mesh.h"

#include <array>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Resultants at the quadrature points of a cell, 5 per point, by state.
    Eigen::MatrixXd
    resultants(const PlateDiscretization &discretization,
               const unsigned int         cell,
               const Eigen::MatrixXd     &states)
    {
      Eigen::MatrixXd values;
      discretization.cell_values(cell, states, values);
      Eigen::MatrixXd result =
        discretization.shape(cell).strains_at_quadrature * values;
      const Eigen::Matrix<double, 5, 5> stiffness =
        discretization.section().stiffness();
      for (Eigen::Index q = 0; q < result.rows(); q += 5)
        result.middleRows<5>(q) = (stiffness * result.middleRows<5>(q)).eval();
      return result;
    }



    Eigen::MatrixXd
    columns(const std::vector<Snapshot> &snapshots)
    {
      Eigen::MatrixXd states(snapshots.front().unknowns.size(),
                             snapshots.size());
      for (unsigned int n = 0; n < snapshots.size(); ++n)
        states.col(n) = snapshots[n].unknowns;
      return states;
    }



    /// Integral over time of the square root of numbers that are 0 at t = 0.
    double
    integral_of_root(const std::vector<double> &times,
                     const Eigen::VectorXd     &squares)
    {
      double integral = 0., last_time = 0., last = 0.;
      for (unsigned int n = 0; n < times.size(); ++n)
        {
          const double value = std::sqrt(squares[n]);
          integral += 0.5 * (times[n] - last_time) * (last + value);
          last_time = times[n];
          last      = value;
        }
      return integral;
    }



    /// Interpolation from the points of a tensor-product Gauss rule.
    class GaussInterpolation
    {
    public:
      explicit GaussInterpolation(const unsigned int n_points)
        : basis(Polynomials::generate_complete_Lagrange_basis(
            QGauss<1>(n_points).get_points()))
      {}

      /// Weights of the points, x fastest.
      Eigen::VectorXd
      weights(const Point<2> &unit_point) const
      {
        const unsigned int n = basis.size();
        Eigen::VectorXd    result(n * n);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            result[n * j + i] =
              basis[i].value(unit_point[0]) * basis[j].value(unit_point[1]);
        return result;
      }

    private:
      const std::vector<Polynomials::Polynomial<double>> basis;
    };
  } // namespace



  ReferenceError::ReferenceError(const PlateDiscretization   &fine,
                                 const std::vector<Snapshot> &snapshots)
  {
    for (const Snapshot &snapshot : snapshots)
      times.push_back(snapshot.time);
    const Eigen::MatrixXd        states = columns(snapshots);
    const std::vector<Point<2>> &unit_points =
      fine.element().quadrature().get_points();
    exact.resize(5 * unit_points.size() * fine.mesh().n_active_cells(),
                 times.size());
    for (const auto &cell : fine.mesh().active_cell_iterators())
      {
        const unsigned int c = cell->active_cell_index();
        exact.middleRows(5 * points.size(), 5 * unit_points.size()) =
          resultants(fine, c, states);
        for (unsigned int q = 0; q < unit_points.size(); ++q)
          {
            points.push_back(
              mapping_of(cell).transform_unit_to_real_cell(cell,
                                                           unit_points[q]));
            weights.push_back(fine.shape(c).weights[q]);
          }
      }
  }



  double
  ReferenceError::of(const PlateDiscretization   &discretization,
                     const std::vector<Snapshot> &snapshots) const
  {
    const Eigen::MatrixXd        states = columns(snapshots);
    std::vector<Eigen::MatrixXd> of_cell(
      discretization.mesh().n_active_cells());
    const GaussInterpolation interpolation(
      std::lround(std::sqrt(discretization.element().quadrature().size())));
    const Mapping<2>         &mapping = mapping_of(discretization.mesh());
    const GridTools::Cache<2> cache(discretization.mesh(), mapping);
    // curved cells of two meshes differ by a little at the edge, of a cell
    const double    tolerance = &mapping == &curved_mapping() ? 0.05 : 1e-10;
    auto            hint      = discretization.mesh().begin_active();
    Eigen::VectorXd e2 = Eigen::VectorXd::Zero(times.size()), u2 = e2;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const auto [cell, unit_point] =
          GridTools::find_active_cell_around_point(cache,
                                                   points[p],
                                                   hint,
                                                   {},
                                                   tolerance);
        if (cell == discretization.mesh().end())
          throw ComputationError("a point of the reference lies outside of the "
                                 "mesh that is compared");
        hint                        = cell;
        Eigen::MatrixXd &cell_field = of_cell[cell->active_cell_index()];
        if (cell_field.size() == 0)
          cell_field =
            resultants(discretization, cell->active_cell_index(), states);
        const Eigen::VectorXd shares = interpolation.weights(unit_point);
        Eigen::MatrixXd       field  = Eigen::MatrixXd::Zero(5, times.size());
        for (Eigen::Index q = 0; q < shares.size(); ++q)
          field += shares[q] * cell_field.middleRows<5>(5 * q);
        for (unsigned int n = 0; n < times.size(); ++n)
          {
            const Resultants reference = exact.col(n).segment<5>(5 * p);
            const Resultants error     = reference - field.col(n);
            e2[n] +=
              weights[p] * discretization.section().squared_energy_norm(error);
            u2[n] += weights[p] *
              discretization.section().squared_energy_norm(reference);
          }
      }
    return integral_of_root(times, e2) / integral_of_root(times, u2);
  }
} // namespace PlateImpact
