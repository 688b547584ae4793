#ifndef plate_impact_estimator_sample_buffer_h
#define plate_impact_estimator_sample_buffer_h

#include "plate_impact/estimator/error_estimator.h"
#include "plate_impact/estimator/kelly_indicator.h"
#include "plate_impact/plate/snapshot.h"
#include "plate_impact/transient/ritz_basis.h"
#include "plate_impact/transient/time_stepper.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace PlateImpact
{
  /// States that wait to be judged together: many make matrix products fast; on
  /// large meshes, where one is work enough, few save memory.
  class SampleBuffer
  {
  public:
    /// @param reduced  the plate that the states belong to; null: the mesh
    SampleBuffer(const ReducedSystem *reduced,
                 unsigned int         n_states,
                 unsigned int         n_cells);

    /// @return whether it is time to judge
    bool
    add(double time, const Eigen::VectorXd &state);

    /// @param kelly  null where it is not wanted
    void
    judge(ErrorEstimator &estimator, KellyIndicator *kelly);

  private:
    const ReducedSystem *reduced;
    const unsigned int   limit;
    std::vector<double>  times;
    Eigen::MatrixXd      states;
  };


  /// Takes the states that the report shows: that of the largest force, and
  /// frames of a film, at most 48, fewer where they would take more than 64 MB.
  class ReportedStates
  {
  public:
    /// @param reduced  as above
    ReportedStates(const ReducedSystem *reduced,
                   unsigned int         n_samples,
                   unsigned int         n_unknowns);

    /// Samples of the estimator from frame to frame.
    unsigned int
    samples_per_frame() const;

    void
    take_step(const TimeStepper &stepper);

    void
    take_sample(const TimeStepper &stepper);

    /// On the mesh.
    std::optional<Snapshot>
    peak_state() const;
    std::vector<Snapshot>
    frames() const;

  private:
    const ReducedSystem  *reduced;
    const unsigned int    frame_interval;
    unsigned int          n_samples  = 0;
    double                peak_force = 0.;
    Snapshot              peak;
    std::vector<Snapshot> film;
  };
} // namespace PlateImpact

#endif
