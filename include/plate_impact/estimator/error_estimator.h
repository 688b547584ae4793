#pragma once

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <vector>

namespace PlateImpact
{
  /// Errors over what a target allows (Table 1 of the paper): every cell may
  /// have the same share of the target,
  ///   e_m = target (||u||^2 + ||e||^2)^{1/2} / n^{1/2},
  /// so that the target is met when all cells keep to it. n is the number of
  /// cells that count, e_m their limit and that of singular ones.
  struct ErrorRatios
  {
    double overall       = 0.; ///< eta / target
    double element_limit = 0.; ///< e_m / (||u||^2 + ||e||^2)^{1/2}
    /// xi' = 1/T int ||e||_i / e_m dt, by active index.
    std::vector<double> elements;

    double
    max_element() const
    {
      return *std::max_element(elements.begin(), elements.end());
    }
  };


  /// Result of the estimator for one mesh; cells by active index.
  struct ErrorEstimate
  {
    /// Relative error in the energy norm, eta, a fraction, over the cells that
    /// count.
    double eta = 0.;

    /// The same with the singular cells and without them.
    double eta_of_all_cells = 0., eta_of_regular_cells = 0.;

    unsigned int n_singular_cells     = 0;
    bool         singular_cells_count = false;

    /// Errors of all cells relative to the whole, the mean over time of
    /// ||e||_i / (||u||^2 + ||e||^2)^{1/2}, with the denominator over the cells
    /// that count.
    std::vector<double> element_errors;

    /// Largest PlateSection::stresses() over vertices and samples, from
    /// recovered resultants. [Pa]
    Eigen::MatrixXd max_stresses;

    /// Relative error ||e|| / (||u||^2 + ||e||^2)^{1/2} at the samples; eta is
    /// its mean with the denominator as weight.
    std::vector<double> sample_times, sample_errors;

    /// The same without the mean, at the samples that were to be kept.
    std::vector<Eigen::VectorXf> kept_element_errors;

    ErrorRatios
    ratios(const double target_error) const
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
  };


  /// Integral over time of what is zero at t = 0, by the trapezoidal rule.
  template <typename Value>
  struct TimeIntegral
  {
    explicit TimeIntegral(const Value &zero)
      : integral(zero)
      , last(zero)
    {}

    void
    add(const double at, const Value &integrand)
    {
      integral += 0.5 * (at - time) * (last + integrand);
      time = at;
      last = integrand;
    }

    Value  integral, last; ///< so far, and the last integrand
    double time = 0.;      ///< of the last one [s]
  };


  /// Few orthonormal combinations, a column each, of the vectors that states
  /// are combinations of.
  /// @param coordinates  of the states, a row per vector
  /// @param tolerance    what the combinations may leave out of the states,
  ///                     relative to the largest
  inline Eigen::MatrixXd
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
