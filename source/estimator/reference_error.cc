#include "plate_impact/estimator/reference_error.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/grid_tools_cache.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/estimator/energy_norm_estimator.h"
#include "plate_impact/plate/plate_mesh.h"

#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Resultants at the quadrature points of a cell, point by point, a column
    /// per state.
    Eigen::MatrixXd
    resultants(const PlateDiscretization &discretization,
               const unsigned int         cell,
               const Eigen::MatrixXd     &states)
    {
      return by_resultant(
        resultants_at(discretization,
                      cell,
                      discretization.section().stiffness(),
                      discretization.shape(cell).at_quadrature,
                      states),
        discretization.section().n_resultants());
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
  } // namespace



  ReferenceError::ReferenceError(const PlateDiscretization   &fine,
                                 const std::vector<Snapshot> &snapshots)
  {
    for (const Snapshot &snapshot : snapshots)
      times.push_back(snapshot.time);
    const Eigen::MatrixXd        states = columns(snapshots);
    const std::vector<Point<2>> &unit_points =
      fine.element.quadrature.get_points();
    const unsigned int m = fine.section().n_resultants();
    exact.resize(m * unit_points.size() * fine.mesh().n_active_cells(),
                 times.size());
    for (const auto &cell : fine.mesh().active_cell_iterators())
      {
        const unsigned int c = cell->active_cell_index();
        exact.middleRows(m * points.size(), m * unit_points.size()) =
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
    const PlateSection          &section = discretization.section();
    const unsigned int           m       = section.n_resultants();
    const Eigen::MatrixXd        states  = columns(snapshots);
    std::vector<Eigen::MatrixXd> of_cell(
      discretization.mesh().n_active_cells());
    const Quadrature<2> &quadrature = discretization.element.quadrature;
    // between the points of a tensor-product Gauss rule
    const FE_DGQArbitraryNodes<2> interpolation(
      QGauss<1>(std::lround(std::sqrt(quadrature.size()))));
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
        Eigen::MatrixXd field = Eigen::MatrixXd::Zero(m, times.size());
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          field += interpolation.shape_value(q, unit_point) *
            cell_field.middleRows(m * q, m);
        for (unsigned int n = 0; n < times.size(); ++n)
          {
            const Eigen::VectorXd reference = exact.col(n).segment(m * p, m),
                                  error     = reference - field.col(n);
            e2[n] += weights[p] * section.squared_energy_norm(error);
            u2[n] += weights[p] * section.squared_energy_norm(reference);
          }
      }
    TimeIntegral<Eigen::Array2d> norms(Eigen::Array2d::Zero());
    for (unsigned int n = 0; n < times.size(); ++n)
      norms.add(times[n], Eigen::Array2d(e2[n], u2[n]).sqrt());
    return norms.integral[0] / norms.integral[1];
  }
} // namespace PlateImpact
