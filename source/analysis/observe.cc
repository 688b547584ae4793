#include "plate_impact/analysis/observe.h"

#include "plate_impact/analysis/stage_charges.h"
#include "plate_impact/analysis/transient_record.h"

#include <utility>

namespace PlateImpact
{
  Wanted
  wanted_by(const Parameters &parameters)
  {
    return {parameters.needs_estimator(),
            parameters.output.write_report,
            parameters.output.field_samples};
  }



  namespace
  {
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
    StageCharges charges(cycle.plate, seen.seconds);
    const auto   stage = [&](const std::string &what) {
      listener.stage(cycle.result.cycle, what);
    };
    const StruckPlate::Work before = cycle.plate.work();
    stage("factors and vectors");
    TransientRecord   record(impact, cycle, wanted, charges, listener);
    const LoadedPlate plate =
      cycle.plate.under(impact, wanted.errors || wanted.fields > 0);
    Impact struck = plate.strike(record);
    record.finish(seen);

    StruckPlate::Work work = cycle.plate.work();
    seen.new_vectors       = work.ritz_vectors - before.ritz_vectors;
    seen.new_solves        = work.linear_solves - before.linear_solves;
    seen.time              = impact.time;
    seen.impulse           = struck.impulse;
    seen.separation_time   = struck.separation_time;
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

    work                     = cycle.plate.work();
    seen.work.factorizations = work.factorizations;
    seen.work.linear_solves  = work.linear_solves;
    seen.work.ritz_vectors   = work.ritz_vectors;
    seen.work.contact_steps  = struck.n_contact_steps;
    seen.work.estimator_samples =
      seen.error ? seen.error->sample_times.size() : 0;
    seen.history = std::move(struck.history);
    return seen;
  }
} // namespace PlateImpact
