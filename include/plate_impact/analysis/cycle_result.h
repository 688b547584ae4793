#ifndef plate_impact_analysis_cycle_result_h
#define plate_impact_analysis_cycle_result_h

#include "plate_impact/analysis/observation.h"
#include "plate_impact/analysis/peak_force_bar.h"
#include "plate_impact/estimator/error_over_limit.h"

#include <optional>
#include <vector>

namespace PlateImpact
{
  /// The peak force again, on the mesh with every cell halved.
  struct Verification
  {
    unsigned int cells;
    double       peak_force; ///< [N]
  };

  /// What an observation is worth, by the targets of the scene.
  struct Judgement
  {
    std::optional<ErrorOverLimit> over_limit; ///< of the energy norm's target
    unsigned int                  cells_above_limit = 0; ///< xi' >= 1
    unsigned int cells_at_minimum_size = 0;     ///< of these, not to be refined
    std::optional<PeakForceBar> peak_force_bar; ///< none on blind meshes
  };

  /// Result of one mesh: the last transient on it, and what it is worth.
  struct CycleResult : Observation, Judgement
  {
    unsigned int cycle = 0; ///< from 1
    unsigned int cells = 0, degrees_of_freedom = 0;
    double       min_cell_size     = 0.; ///< [m]
    double       cell_size_at_load = 0.; ///< of the largest that it touches [m]

    /// xi' by active index; empty where there is no estimate.
    std::vector<double>
    element_errors() const
    {
      return over_limit ? over_limit->elements : std::vector<double>();
    }

    std::vector<double> natural_frequencies; ///< where asked for [Hz]

    std::optional<Verification> verification; ///< where asked for

    double seconds_before = 0.; ///< of all meshes before

    /// From the beginning to the end of this cycle. [s]
    double
    cumulative_seconds() const
    {
      return seconds_before + seconds.total();
    }
  };
} // namespace PlateImpact

#endif
