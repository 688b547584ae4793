#include "plate_impact/estimator/sample_buffer.h"

#include <algorithm>

namespace PlateImpact
{
  SampleBuffer::SampleBuffer(const SemidiscreteSystem &system,
                             ErrorEstimator           &estimator,
                             const unsigned int        n_states)
    : system(system)
    , estimator(estimator)
    , limit(std::min(n_states, system.n_states_at_once()))
  {}



  bool
  SampleBuffer::add(const double time, const Eigen::VectorXd &state)
  {
    if (states.size() == 0)
      states.resize(state.size(), limit);
    states.col(times.size()) = state;
    times.push_back(time);
    return times.size() == limit;
  }



  void
  SampleBuffer::judge()
  {
    if (times.empty())
      return;
    const auto                     waiting = states.leftCols(times.size());
    const SemidiscreteSystem::Span span    = system.span(waiting);
    estimator.add_samples(times, span.vectors, span.coordinates);
    times.clear();
  }
} // namespace PlateImpact
