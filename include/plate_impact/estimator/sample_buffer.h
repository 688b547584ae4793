#ifndef plate_impact_estimator_sample_buffer_h
#define plate_impact_estimator_sample_buffer_h

#include "plate_impact/estimator/error_estimator.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <vector>

namespace PlateImpact
{
  /// States that wait to be judged together.
  class SampleBuffer
  {
  public:
    /// Both must outlive the buffer.
    /// @param system    that the states belong to
    /// @param n_states  that will come
    SampleBuffer(const SemidiscreteSystem &system,
                 ErrorEstimator           &estimator,
                 unsigned int              n_states);

    /// @return whether it is time to judge
    bool
    add(double time, const Eigen::VectorXd &state);

    /// Gives what waits to the estimator.
    void
    judge();

  private:
    const SemidiscreteSystem &system;
    ErrorEstimator           &estimator;
    const unsigned int        limit;
    std::vector<double>       times;
    Eigen::MatrixXd           states;
  };
} // namespace PlateImpact

#endif
