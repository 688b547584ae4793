#pragma once

#include "plate_impact/estimator/error_estimator.h"
#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace PlateImpact
{
  /// Where the error is, by the jumps across the sides of cells instead of a
  /// recovered field (Kelly, Gago, Zienkiewicz & Babuska 1983,
  /// doi:10.1002/nme.1620191103; deal.II's KellyErrorEstimator):
  ///   eta_i^2 = h_i/24 sum over sides int (kappa G t [dw/dn]^2 + D
  ///   [dtheta/dn]^2),
  /// with the shear and bending stiffness, so that both jumps count as
  /// energies. The jumps only rank the cells: how large the error is together
  /// stays what another estimator says, whose errors of the elements give way
  /// to
  ///   eta 1/T int eta_i / (sum eta_j^2)^{1/2} dt,
  /// an overall error of eta spread as the jumps are. For teaching what the
  /// recovery adds.
  class KellyEstimator : public ErrorEstimator
  {
  public:
    /// @param discretization  must outlive the estimator
    /// @param amount          says how large the error is
    KellyEstimator(const PlateDiscretization      &discretization,
                   std::unique_ptr<ErrorEstimator> amount)
      : discretization(discretization)
      , amount(std::move(amount))
      , shares(Eigen::VectorXd::Zero(discretization.mesh().n_active_cells()))
    {}

    void
    add_samples(const std::vector<double>               &times,
                const Eigen::Ref<const Eigen::MatrixXd> &vectors,
                const Eigen::MatrixXd                   &coordinates) override;

    ErrorEstimate
    estimate() const override;

  private:
    const PlateDiscretization            &discretization;
    const std::unique_ptr<ErrorEstimator> amount;
    TimeIntegral<Eigen::VectorXd>         shares;
  };
} // namespace PlateImpact
