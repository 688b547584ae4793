#include "plate_impact/sampled_states.h"

#include <algorithm>

namespace PlateImpact
{
  WaitingStates::WaitingStates(const RitzPlate   *reduced,
                               const unsigned int n_states,
                               const unsigned int n_cells)
    : reduced(reduced)
    , limit(std::min(n_states,
                     reduced ? 500u : std::clamp(200000u / n_cells, 1u, 16u)))
  {}



  bool
  WaitingStates::add(const double time, const Eigen::VectorXd &state)
  {
    if (states.size() == 0)
      states.resize(state.size(), limit);
    states.col(times.size()) = state;
    times.push_back(time);
    return times.size() == limit;
  }



  void
  WaitingStates::judge(ErrorEstimator &estimator, KellyIndicator *kelly)
  {
    if (times.empty())
      return;
    const auto waiting = states.leftCols(times.size());
    if (reduced != nullptr)
      estimator.add_samples(times, reduced->vectors(), waiting);
    else
      estimator.add_samples(times, waiting);
    if (kelly != nullptr && reduced != nullptr)
      kelly->add_samples(times, reduced->vectors() * waiting);
    else if (kelly != nullptr)
      kelly->add_samples(times, waiting);
    times.clear();
  }



  ReportedStates::ReportedStates(const RitzPlate   *reduced,
                                 const unsigned int n_samples,
                                 const unsigned int n_unknowns)
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
  ReportedStates::take_sample(const TimeStepper     &stepper,
                              std::vector<Snapshot> &frames)
  {
    if (++n_samples % frame_interval == 0)
      frames.push_back(
        unreduced({stepper.state().time, stepper.displacement()}));
  }



  std::optional<Snapshot>
  ReportedStates::peak_state() const
  {
    if (peak_force == 0.)
      return {};
    return unreduced(peak);
  }



  Snapshot
  ReportedStates::unreduced(const Snapshot &state) const
  {
    if (reduced == nullptr)
      return state;
    return {state.time, reduced->vectors() * state.unknowns};
  }
} // namespace PlateImpact
