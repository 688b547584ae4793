#include "plate_impact/estimator/kelly_estimator.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>

#include "plate_impact/plate/plate_mesh.h"

#include <cmath>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// h/24 sum int [du/dn]^2 of some components by cell (rows) and state.
    Eigen::MatrixXd
    squared_jumps(const DoFHandler<2>               &dof_handler,
                  const std::vector<Vector<double>> &states,
                  const ComponentMask               &components)
    {
      std::vector<const Vector<double> *> pointers;
      std::vector<Vector<float>>          jumps(states.size());
      std::vector<Vector<float> *>        results;
      for (unsigned int n = 0; n < states.size(); ++n)
        {
          pointers.push_back(&states[n]);
          results.push_back(&jumps[n]);
        }
      KellyErrorEstimator<2>::estimate(
        mapping_of(dof_handler.get_triangulation()),
        dof_handler,
        QGauss<1>(3),
        {},
        pointers,
        results,
        components,
        nullptr,
        numbers::invalid_unsigned_int,
        numbers::invalid_subdomain_id,
        numbers::invalid_material_id,
        KellyErrorEstimator<2>::cell_diameter_over_24);
      Eigen::MatrixXd squares(jumps.front().size(), jumps.size());
      for (unsigned int n = 0; n < jumps.size(); ++n)
        for (unsigned int cell = 0; cell < jumps[n].size(); ++cell)
          squares(cell, n) = double(jumps[n][cell]) * jumps[n][cell];
      return squares;
    }
  } // namespace



  KellyEstimator::KellyEstimator(const PlateDiscretization      &discretization,
                                 std::unique_ptr<ErrorEstimator> amount)
    : discretization(discretization)
    , amount(std::move(amount))
    , shares_integral(
        Eigen::VectorXd::Zero(discretization.mesh().n_active_cells()))
    , last_shares(shares_integral)
  {}



  void
  KellyEstimator::add_samples(const std::vector<double>               &times,
                              const Eigen::Ref<const Eigen::MatrixXd> &vectors,
                              const Eigen::MatrixXd &coordinates)
  {
    amount->add_samples(times, vectors, coordinates);
    add_jumps(times, vectors * coordinates);
  }



  void
  KellyEstimator::add_jumps(const std::vector<double> &times,
                            const Eigen::MatrixXd     &unknowns)
  {
    // jumps are kept as floats by deal.II: states are scaled to numbers near 1
    std::vector<Vector<double>> states;
    for (Eigen::Index n = 0; n < unknowns.cols(); ++n)
      {
        const double largest = unknowns.col(n).cwiseAbs().maxCoeff();
        states.push_back(discretization.nodal_values(
          unknowns.col(n) / (largest > 0. ? largest : 1.)));
      }
    ComponentMask slopes(n_components, false), rotations(n_components, true);
    slopes.set(deflection, true);
    rotations.set(deflection, false);
    const Eigen::MatrixXd squares =
      discretization.section().mean_shear_stiffness() *
        squared_jumps(discretization.dof_handler(), states, slopes) +
      discretization.section().mean_bending_stiffness() *
        squared_jumps(discretization.dof_handler(), states, rotations);
    for (unsigned int n = 0; n < times.size(); ++n)
      {
        const double    sum    = squares.col(n).sum();
        Eigen::VectorXd shares = Eigen::VectorXd::Zero(squares.rows());
        if (sum > 0.)
          shares = (squares.col(n) / sum).cwiseSqrt();
        shares_integral +=
          0.5 * (times[n] - last_time) * (last_shares + shares);
        last_time   = times[n];
        last_shares = shares;
      }
  }



  ErrorEstimate
  KellyEstimator::estimate() const
  {
    ErrorEstimate result = amount->estimate();
    if (last_time > 0.)
      for (unsigned int cell = 0; cell < result.element_errors.size(); ++cell)
        result.element_errors[cell] =
          result.eta * shares_integral[cell] / last_time;
    return result;
  }
} // namespace PlateImpact
