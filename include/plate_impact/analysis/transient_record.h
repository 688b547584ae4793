#ifndef plate_impact_analysis_transient_record_h
#define plate_impact_analysis_transient_record_h

#include "plate_impact/analysis/analysis_listener.h"
#include "plate_impact/analysis/observation.h"
#include "plate_impact/analysis/stage_charges.h"
#include "plate_impact/estimator/sample_buffer.h"
#include "plate_impact/plate/snapshot.h"
#include "plate_impact/transient/loaded_plate.h"

#include <memory>
#include <optional>
#include <vector>

namespace PlateImpact
{
  class Cycle;

  /// What is kept of a transient while it is stepped: samples for the
  /// estimator, states for the fields, and what the page shows, the state of
  /// the largest force and frames of a film, at most 48, fewer where they would
  /// take more than 64 MB.
  class TransientRecord : public TransientListener
  {
  public:
    /// All must outlive the record.
    TransientRecord(const Parameters &parameters,
                    Cycle            &cycle,
                    const Wanted     &wanted,
                    StageCharges     &charges,
                    AnalysisListener &listener);

    void
    begin(const SemidiscreteSystem &system,
          const TimeStepper        &stepper) override;

    void
    take_step(unsigned int step, const TimeStepper &stepper) override;

    /// Puts what was kept into an observation.
    void
    finish(Observation &seen);

  private:
    void
    judge();
    /// Whether files of fields show the state after a step.
    bool
    is_field(unsigned int step) const;
    /// On the mesh.
    std::vector<Snapshot>
    unknowns_of(std::vector<Snapshot> states) const;

    const Parameters &parameters;
    Cycle            &cycle;
    const Wanted     &wanted;
    StageCharges     &charges;
    AnalysisListener &listener;

    /// from begin() on
    const SemidiscreteSystem *system = nullptr;
    unsigned int n_steps = 0, sampling_interval = 0, samples_per_frame = 0,
                 n_samples = 0;
    std::unique_ptr<ErrorEstimator> estimator; ///< where errors are wanted
    std::optional<SampleBuffer>     buffer;

    /// in coordinates of the system
    std::vector<Snapshot> fields, film, peak; ///< the last one or none
    double                peak_force = 0.;
  };
} // namespace PlateImpact

#endif
