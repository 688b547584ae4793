#ifndef plate_impact_estimator_error_estimator_h
#define plate_impact_estimator_error_estimator_h

#include <Eigen/Core>

#include <vector>

namespace PlateImpact
{
  /// Result of the estimator for one mesh; cells by active index.
  struct ErrorEstimate
  {
    /// Relative error in the energy norm, eta, a fraction; without the singular
    /// cells.
    double eta = 0.;

    /// The same with them.
    double eta_of_all_cells = 0.;

    unsigned int n_singular_cells = 0;

    /// Errors of the cells relative to the whole, the mean over time of
    /// ||e||_i / (||u||^2 + ||e||^2)^{1/2}; the denominator leaves out the
    /// singular cells.
    std::vector<double> element_errors;

    /// Largest PlateSection::stresses() over vertices and samples, from
    /// recovered resultants. [Pa]
    Eigen::MatrixXd max_stresses;

    /// Relative error ||e|| / (||u||^2 + ||e||^2)^{1/2} at the samples, without
    /// singular cells; eta is its mean with the denominator as weight.
    std::vector<double> sample_times, sample_errors;

    /// The same without the mean, at the samples that were to be kept.
    std::vector<Eigen::VectorXf> kept_element_errors;
  };


  /// Tells the error of a transient on a mesh from states of the plate.
  class ErrorEstimator
  {
  public:
    virtual ~ErrorEstimator() = default;

    /// Takes states at times later than those before, as combinations of
    /// vectors, and judges all of them together.
    /// @param times        [s]
    /// @param vectors      unknowns of the plate, a column per vector
    /// @param coordinates  a row per vector, a column per time
    virtual void
    add_samples(const std::vector<double>               &times,
                const Eigen::Ref<const Eigen::MatrixXd> &vectors,
                const Eigen::MatrixXd                   &coordinates) = 0;

    /// Error over all samples; the plate is at rest at t = 0.
    virtual ErrorEstimate
    estimate() const = 0;
  };
} // namespace PlateImpact

#endif
