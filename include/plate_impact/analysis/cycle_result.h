#ifndef plate_impact_analysis_cycle_result_h
#define plate_impact_analysis_cycle_result_h

#include "plate_impact/analysis/peak_force_bar.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/estimator/error_estimator.h"
#include "plate_impact/estimator/error_over_limit.h"
#include "plate_impact/estimator/peak_force_error.h"
#include "plate_impact/plate/snapshot.h"
#include "plate_impact/transient/sensitivity.h"

#include <optional>
#include <vector>

namespace PlateImpact
{
  /// What a scene paid for.
  struct Work
  {
    unsigned int factorizations    = 0;
    unsigned int linear_solves     = 0;
    unsigned int contact_steps     = 0; ///< with a force other than zero
    unsigned int estimator_samples = 0;
    unsigned int ritz_vectors      = 0;
  };

  /// Wall time of the stages of a cycle, every second in one of them. [s]
  struct Seconds
  {
    double mesh = 0., assembly = 0., factorization = 0., stepping = 0.,
           estimation = 0., output = 0.;

    double
    total() const
    {
      return mesh + assembly + factorization + stepping + estimation + output;
    }
  };

  /// The peak force again, on the mesh with every cell halved.
  struct Verification
  {
    unsigned int cells;
    double       peak_force; ///< [N]
  };

  /// Result of one mesh. Empty optionals are quantities that the scene does not
  /// have.
  struct CycleResult
  {
    unsigned int cycle = 0; ///< from 1
    unsigned int cells = 0, degrees_of_freedom = 0;
    double       min_cell_size     = 0.; ///< [m]
    double       cell_size_at_load = 0.; ///< of the largest that it touches [m]

    std::optional<ErrorEstimate>  error;
    std::optional<ErrorOverLimit> over_limit; ///< of the scene's target

    /// xi' by active index; empty where there is no estimate.
    std::vector<double>
    element_errors() const
    {
      return over_limit ? over_limit->elements : std::vector<double>();
    }

    unsigned int cells_above_limit     = 0; ///< xi' >= 1
    unsigned int cells_at_minimum_size = 0; ///< of these, not to be refined

    std::optional<ContactHistory> history;
    unsigned int                  steps   = 0;
    double                        impulse = 0.;     ///< [N s]
    std::optional<double>         separation_time;  ///< no contact since [s]
    std::optional<PeakForceError> peak_force_error; ///< by the mesh
    std::optional<PeakForceBar>   peak_force_bar;   ///< none on blind meshes
    std::optional<double> time_error; ///< of the peak force, relative to it
    std::optional<Sensitivity> sensitivity; ///< of several contacts
    std::vector<Snapshot>      snapshots;

    std::vector<double> natural_frequencies; ///< where asked for [Hz]

    /// For the report: the state of the largest force, and states evenly over
    /// the samples of the estimator, those of error->kept_element_errors.
    std::optional<Snapshot> peak_state;
    std::vector<Snapshot>   frames;

    std::optional<Verification> verification; ///< where asked for

    Work    work;
    Seconds seconds;
    double  seconds_before = 0.; ///< of all meshes before

    /// From the beginning to the end of this cycle. [s]
    double
    cumulative_seconds() const
    {
      return seconds_before + seconds.total();
    }
  };
} // namespace PlateImpact

#endif
