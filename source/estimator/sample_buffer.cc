#include "plate_impact/estimator/sample_buffer.h"

#include <algorithm>

namespace PlateImpact
{
  SampleBuffer::SampleBuffer(const ReducedSystem *reduced,
                             const unsigned int   n_states,
                             const unsigned int   n_cells)
    : reduced(reduced)
    , limit(std::min(n_states,
                     reduced ? 500u : std::clamp(200000u / n_cells, 1u, 16u)))
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
  SampleBuffer::judge(ErrorEstimator &estimator, KellyIndicator *kelly)
  {
    if (times.empty())
      return;
    const auto waiting = states.leftCols(times.size());
    if (reduced != nullptr)
      estimator.add_samples(times,
                            reduced->vectors(),
                            waiting.topRows(reduced->n_vectors()));
    else
      estimator.add_samples(times, waiting);
    if (kelly != nullptr && reduced != nullptr)
      kelly->add_samples(times, reduced->unknowns(waiting));
    else if (kelly != nullptr)
      kelly->add_samples(times, waiting);
    times.clear();
  }



  ReportedStates::ReportedStates(const ReducedSystem *reduced,
                                 const unsigned int   n_samples,
                                 const unsigned int   n_unknowns)
    : reduced(reduced)
    , frame_interval(1 + n_samples / std::clamp(8000000u / n_unknowns, 8u, 48u))
  {}



  unsigned int
  ReportedStates::samples_per_frame() const
  {
    return frame_interval;
  }



  void
  ReportedStates::take_step(const TimeStepper &stepper)
  {
    if (stepper.state().force > peak_force)
      {
        peak_force = stepper.state().force;
        peak       = {stepper.state().time, stepper.displacement()};
      }
  }



  void
  ReportedStates::take_sample(const TimeStepper &stepper)
  {
    if (++n_samples % frame_interval == 0)
      film.push_back({stepper.state().time, stepper.displacement()});
  }



  std::vector<Snapshot>
  ReportedStates::frames() const
  {
    if (reduced == nullptr || film.empty())
      return film;
    Eigen::MatrixXd coordinates(film.front().unknowns.size(), film.size());
    for (std::size_t i = 0; i < film.size(); ++i)
      coordinates.col(i) = film[i].unknowns;
    // one product of matrices instead of many with a vector
    const Eigen::MatrixXd unknowns = reduced->unknowns(coordinates);
    std::vector<Snapshot> result;
    for (std::size_t i = 0; i < film.size(); ++i)
      result.push_back({film[i].time, unknowns.col(i)});
    return result;
  }



  std::optional<Snapshot>
  ReportedStates::peak_state() const
  {
    if (peak_force == 0.)
      return {};
    if (reduced == nullptr)
      return peak;
    return Snapshot{peak.time, reduced->unknowns(peak.unknowns)};
  }
} // namespace PlateImpact
