#ifndef plate_impact_analysis_observation_h
#define plate_impact_analysis_observation_h

#include "plate_impact/analysis/work.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/estimator/error_estimator.h"
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/plate/snapshot.h"
#include "plate_impact/transient/loaded_plate.h"

#include <optional>
#include <vector>

namespace PlateImpact
{
  /// What somebody wants of a transient besides its force.
  struct Wanted
  {
    bool         errors = false; ///< of the stresses and of the peak force
    bool         film   = false; ///< states for the page
    unsigned int fields = 0;     ///< states for the files of fields
  };

  /// What a transient on a mesh has shown. Empty optionals are quantities that
  /// were not wanted, or that the impact does not have.
  struct Observation
  {
    TimeParameters                time; ///< end and steps of the transient
    std::optional<ContactHistory> history;
    unsigned int                  steps   = 0;
    double                        impulse = 0.;    ///< [N s]
    std::optional<double>         separation_time; ///< no contact since [s]

    std::optional<double> time_error; ///< of the peak force, relative to it
    double vector_error = 0.; ///< the same of Ritz vectors; 0 on the mesh
    std::optional<PeakForceError> peak_force_error; ///< by the mesh
    std::optional<Sensitivity>    sensitivity;      ///< of several contacts
    std::optional<ErrorEstimate>  error;            ///< of the stresses

    std::vector<Snapshot> snapshots; ///< for the files of fields

    /// For the page: the state of the largest force, and states evenly over the
    /// samples of the estimator, those of error->kept_element_errors.
    std::optional<Snapshot> peak_state;
    std::vector<Snapshot>   frames;

    Work    work;    ///< on the mesh, those of transients before included
    Seconds seconds; ///< of this transient

    /// For this force alone: what the choice of steps or vectors is judged by.
    unsigned int new_vectors = 0, new_solves = 0;
  };
} // namespace PlateImpact

#endif
