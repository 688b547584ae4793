#include "plate_impact/analysis/transient_record.h"

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/estimator/make_error_estimator.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Fewer samples over the transient do not make an integral over time.
    constexpr unsigned int min_estimator_samples = 20;

    /// Unknowns in all frames of a film: 64 MB.
    constexpr unsigned int most_frame_unknowns = 8000000;
  } // namespace



  TransientRecord::TransientRecord(const Parameters &parameters,
                                   Cycle            &cycle,
                                   const Wanted     &wanted,
                                   StageCharges     &charges,
                                   AnalysisListener &listener)
    : parameters(parameters)
    , cycle(cycle)
    , wanted(wanted)
    , charges(charges)
    , listener(listener)
  {}



  void
  TransientRecord::begin(const SemidiscreteSystem &stepped,
                         const TimeStepper        &stepper)
  {
    charges.charge(&Seconds::stepping);
    system            = &stepped;
    n_steps           = stepper.n_steps();
    sampling_interval = std::clamp(n_steps / min_estimator_samples,
                                   1u,
                                   parameters.adaptivity.sampling_interval);
    samples_per_frame = 1 +
      n_steps / sampling_interval /
        std::clamp(most_frame_unknowns / cycle.discretization().n_unknowns(),
                   8u,
                   48u);
    if (wanted.errors)
      {
        estimator = make_error_estimator(parameters,
                                         cycle.discretization(),
                                         cycle.recovery(),
                                         wanted.film ? samples_per_frame : 0);
        buffer.emplace(stepped, *estimator, n_steps / sampling_interval + 1);
      }
    charges.charge(&Seconds::estimation);
  }



  void
  TransientRecord::take_step(const unsigned int step,
                             const TimeStepper &stepper)
  {
    const double           time  = stepper.state().time;
    const Eigen::VectorXd &state = stepper.displacement();
    if (is_field(step))
      fields.push_back({time, state});
    if (wanted.film && stepper.state().force > peak_force)
      {
        peak_force = stepper.state().force;
        peak.assign(1, {time, state});
      }
    if (buffer && (step % sampling_interval == 0 || step == n_steps))
      {
        if (wanted.film && ++n_samples % samples_per_frame == 0)
          film.push_back({time, state});
        if (buffer->add(time, state))
          judge();
      }
    listener.step(cycle.result.cycle, step, n_steps);
  }



  void
  TransientRecord::judge()
  {
    charges.charge(&Seconds::stepping);
    buffer->judge();
    charges.charge(&Seconds::estimation);
  }



  bool
  TransientRecord::is_field(const unsigned int step) const
  {
    const std::uint64_t n_fields = wanted.fields;
    // steps at which k n_steps / n_fields passes a whole number
    return step * n_fields / n_steps > (step - 1) * n_fields / n_steps;
  }



  std::vector<Snapshot>
  TransientRecord::unknowns_of(std::vector<Snapshot> states) const
  {
    // products of matrices instead of many with a vector, a few at a time
    const std::size_t batch = 16;
    for (std::size_t first = 0; first < states.size(); first += batch)
      {
        const std::size_t n = std::min(batch, states.size() - first);
        Eigen::MatrixXd   columns(states[first].unknowns.size(), n);
        for (std::size_t i = 0; i < n; ++i)
          columns.col(i) = states[first + i].unknowns;
        const Eigen::MatrixXd unknowns = system->unknowns(columns);
        for (std::size_t i = 0; i < n; ++i)
          states[first + i].unknowns = unknowns.col(i);
      }
    return states;
  }



  void
  TransientRecord::finish(Observation &seen)
  {
    charges.charge(&Seconds::stepping);
    seen.steps     = n_steps;
    seen.snapshots = unknowns_of(std::move(fields));
    seen.frames    = unknowns_of(std::move(film));
    if (!peak.empty())
      seen.peak_state = unknowns_of(peak).front();
    if (buffer)
      {
        buffer->judge();
        seen.error = estimator->estimate();
      }
    charges.charge(&Seconds::estimation);
  }
} // namespace PlateImpact
