#include "plate_impact/analysis/observe.h"

#include "plate_impact/estimator/make_error_estimator.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Fewer samples over the transient do not make an integral over time.
    constexpr unsigned int min_estimator_samples = 20;

    /// More than these cost time alone, where the program chooses short steps.
    constexpr unsigned int most_estimator_samples = 1000;

    /// Unknowns in all frames of a film: 64 MB.
    constexpr unsigned int most_frame_unknowns = 8000000;



    unsigned int
    sampling_interval_of(const Parameters &impact, const unsigned int n_steps)
    {
      const unsigned int least =
        impact.time.step_is_chosen ? n_steps / most_estimator_samples : 0;
      return std::clamp(n_steps / min_estimator_samples,
                        1u,
                        std::max(least, impact.adaptivity.sampling_interval));
    }



    /// What is kept of a transient while it is stepped: samples for the
    /// estimator, states for the fields, and what the page shows, the state of
    /// the largest force and frames of a film, at most 48, fewer where they
    /// would take more than 64 MB.
    class TransientRecord
    {
    public:
      /// All must outlive the record.
      /// @param system  that is stepped
      TransientRecord(const Parameters         &impact,
                      const Cycle              &cycle,
                      const Wanted             &wanted,
                      const SemidiscreteSystem &system,
                      StageCharges             &charges,
                      AnalysisListener         &listener)
        : cycle(cycle)
        , wanted(wanted)
        , system(system)
        , charges(charges)
        , listener(listener)
        , n_steps(
            NewmarkScheme(impact.time, impact.contact.integration).n_steps)
        , sampling_interval(sampling_interval_of(impact, n_steps))
        , n_samples_at_once(std::min(n_steps / sampling_interval + 1,
                                     system.n_states_at_once()))
        , samples_per_frame(1 +
                            n_steps / sampling_interval /
                              std::clamp(most_frame_unknowns /
                                           cycle.discretization().n_unknowns(),
                                         8u,
                                         48u))
      {
        charges.charge(&Seconds::stepping);
        if (wanted.errors)
          estimator = make_error_estimator(impact,
                                           cycle.discretization(),
                                           cycle.recovery(),
                                           wanted.film ? samples_per_frame : 0);
        charges.charge(&Seconds::estimation);
      }

      void
      take_step(const unsigned int step, const TimeStepper &stepper)
      {
        const double           time  = stepper.state().time;
        const Eigen::VectorXd &state = stepper.displacement();
        // steps at which k n_steps / fields passes a whole number
        const std::uint64_t n_fields = wanted.fields;
        if (step * n_fields / n_steps > (step - 1) * n_fields / n_steps)
          fields.push_back({time, state});
        if (wanted.film && stepper.state().force > peak_force)
          {
            peak_force = stepper.state().force;
            peak.assign(1, {time, state});
          }
        if (estimator && (step % sampling_interval == 0 || step == n_steps))
          {
            if (wanted.film && ++n_samples % samples_per_frame == 0)
              film.push_back({time, state});
            if (times.empty())
              states.resize(state.size(), n_samples_at_once);
            states.col(times.size()) = state;
            times.push_back(time);
            if (times.size() == n_samples_at_once)
              {
                charges.charge(&Seconds::stepping);
                estimate();
                charges.charge(&Seconds::estimation);
              }
          }
        listener.step(cycle.result.cycle, step, n_steps);
      }

      /// Puts what was kept into an observation.
      void
      finish(Observation &seen)
      {
        charges.charge(&Seconds::stepping);
        seen.steps     = n_steps;
        seen.snapshots = unknowns_of(std::move(fields));
        seen.frames    = unknowns_of(std::move(film));
        if (!peak.empty())
          seen.peak_state = unknowns_of(peak).front();
        if (estimator)
          {
            estimate();
            seen.error = estimator->estimate();
          }
        charges.charge(&Seconds::estimation);
      }

    private:
      /// Gives the samples that wait to the estimator.
      void
      estimate()
      {
        if (times.empty())
          return;
        const auto span = system.span(states.leftCols(times.size()));
        estimator->add_samples(times, span.vectors, span.coordinates);
        times.clear();
      }

      /// On the mesh.
      std::vector<Snapshot>
      unknowns_of(std::vector<Snapshot> snapshots) const
      {
        // products of matrices instead of many with a vector, a few at a time
        const std::size_t batch = 16;
        for (std::size_t first = 0; first < snapshots.size(); first += batch)
          {
            const std::size_t n = std::min(batch, snapshots.size() - first);
            Eigen::MatrixXd   columns(snapshots[first].unknowns.size(), n);
            for (std::size_t i = 0; i < n; ++i)
              columns.col(i) = snapshots[first + i].unknowns;
            const auto            span     = system.span(columns);
            const Eigen::MatrixXd unknowns = span.vectors * span.coordinates;
            for (std::size_t i = 0; i < n; ++i)
              snapshots[first + i].unknowns = unknowns.col(i);
          }
        return snapshots;
      }

      const Cycle              &cycle;
      const Wanted             &wanted;
      const SemidiscreteSystem &system;
      StageCharges             &charges;
      AnalysisListener         &listener;

      const unsigned int n_steps, sampling_interval, n_samples_at_once,
        samples_per_frame;
      unsigned int                    n_samples = 0;
      std::unique_ptr<ErrorEstimator> estimator; ///< where errors are wanted

      /// in coordinates of the system
      std::vector<Snapshot> fields, film, peak; ///< the last one or none
      double                peak_force = 0.;
      std::vector<double>   times;  ///< of samples that wait
      Eigen::MatrixXd       states; ///< at these
    };



    /// Empty for loads under which the exact energy is infinite, and where
    /// there is no dual problem.
    std::optional<PeakForceError>
    error_of_peak(const Cycle          &cycle,
                  const Parameters     &impact,
                  const LoadedPlate    &plate,
                  const ContactHistory &history)
    {
      if (impact.contact.load_is_singular())
        return {};
      const auto problem = plate.peak_force_problem(history);
      if (!problem)
        return {};
      return estimated_peak_force_error(cycle.discretization(),
                                        cycle.recovery(),
                                        *problem->system,
                                        problem->motions,
                                        history.peak().force);
    }
  } // namespace



  Observation
  observe(Cycle            &cycle,
          const Parameters &impact,
          const Wanted     &wanted,
          AnalysisListener &listener)
  {
    Observation  seen;
    StageCharges charges(cycle.plate, cycle.result.seconds);
    const auto   stage = [&](const std::string &what) {
      listener.stage(cycle.result.cycle, what);
    };
    const PlateModel::Work before = cycle.plate.work();
    stage("factors and vectors");
    const LoadedPlate plate =
      cycle.plate.under(impact, wanted.errors || wanted.fields > 0);
    TransientRecord record(impact,
                           cycle,
                           wanted,
                           plate.stepped_system(),
                           charges,
                           listener);
    Impact          struck =
      plate.strike([&](const unsigned int step, const TimeStepper &stepper) {
        record.take_step(step, stepper);
      });
    record.finish(seen);

    const PlateModel::Work work = cycle.plate.work();
    seen.new_vectors            = work.ritz_vectors - before.ritz_vectors;
    seen.new_solves             = work.linear_solves - before.linear_solves;
    seen.time                   = impact.time;
    seen.impulse                = struck.impulse;
    seen.separation_time        = struck.separation_time;
    seen.damping                = plate.stepped_system().damping();
    seen.vector_error =
      plate.is_stepped_on_the_mesh() ? 0. : impact.time.ritz_tolerance;
    if (wanted.errors)
      stage("error of the force");
    seen.sensitivity = plate.sensitivity(struck.history);
    seen.time_error  = plate.time_error(struck.history);
    charges.charge(&Seconds::stepping);
    if (wanted.errors)
      seen.peak_force_error =
        error_of_peak(cycle, impact, plate, struck.history);
    charges.charge(&Seconds::estimation);

    seen.work          = cycle.plate.work();
    seen.contact_steps = struck.n_contact_steps;
    seen.history       = std::move(struck.history);
    return seen;
  }
} // namespace PlateImpact
