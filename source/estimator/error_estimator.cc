#include "plate_impact/estimator/error_estimator.h"

#include <Eigen/QR>

#include <cmath>

namespace PlateImpact
{
  ErrorRatios
  ErrorEstimate::ratios(const double target_error) const
  {
    // without cells that count the limit is that of one
    const std::size_t n_counted =
      element_errors.size() - (singular_cells_count ? 0 : n_singular_cells);
    ErrorRatios result;
    result.overall = eta / target_error;
    result.element_limit =
      target_error / std::sqrt(std::max<double>(1., n_counted));
    for (const double error : element_errors)
      result.elements.push_back(error / result.element_limit);
    return result;
  }



  Eigen::MatrixXd
  leading_combinations(const Eigen::MatrixXd &coordinates,
                       const double           tolerance)
  {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
    qr.setThreshold(tolerance);
    qr.compute(coordinates);
    return qr.householderQ() *
      Eigen::MatrixXd::Identity(coordinates.rows(), qr.rank());
  }
} // namespace PlateImpact
