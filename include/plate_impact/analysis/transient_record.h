#ifndef plate_impact_analysis_transient_record_h
#define plate_impact_analysis_transient_record_h

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/base/stage_clock.h"
#include "plate_impact/estimator/sample_buffer.h"
#include "plate_impact/plate/snapshot.h"
#include "plate_impact/transient/struck_plate.h"

#include <functional>
#include <optional>
#include <vector>

namespace PlateImpact
{
  /// What is kept of a transient while it is stepped: samples for the
  /// estimator, states for the fields, and what the report shows, the state of
  /// the largest force and frames of a film, at most 48, fewer where they would
  /// take more than 64 MB.
  class TransientRecord : public TransientListener
  {
  public:
    /// Told after every step: the step and the number of steps.
    using Progress = std::function<void(unsigned int, unsigned int)>;

    /// @param cycle  that is computed; gets its estimator, and seconds are
    ///               charged to its result. All must outlive the record
    TransientRecord(const Parameters &parameters,
                    Cycle            &cycle,
                    const Progress   &progress);

    void
    begin(const SemidiscreteSystem &system,
          const TimeStepper        &stepper) override;

    void
    take_step(unsigned int step, const TimeStepper &stepper) override;

    /// Puts what was kept into the result of the cycle, and the last samples
    /// into its estimator.
    void
    finish();

  private:
    void
    judge();
    /// Whether VTU files show the state after a step.
    bool
    is_field(unsigned int step) const;
    /// On the mesh.
    std::vector<Snapshot>
    unknowns_of(std::vector<Snapshot> states) const;

    const Parameters &parameters;
    Cycle            &cycle;
    CycleResult      &result;
    const Progress    progress;
    StageClock        clock;

    /// from begin() on
    const SemidiscreteSystem *system = nullptr;
    unsigned int n_steps = 0, sampling_interval = 0, samples_per_frame = 0,
                 n_samples = 0;
    std::optional<SampleBuffer> buffer; ///< where an estimator is wanted

    /// in coordinates of the system
    std::vector<Snapshot> fields, film, peak; ///< the last one or none
    double                peak_force = 0.;
  };
} // namespace PlateImpact

#endif
