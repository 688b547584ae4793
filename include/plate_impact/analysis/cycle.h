#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/plate_model.h"

#include <memory>
#include <optional>

namespace PlateImpact
{
  /// A mesh of an analysis with all that is made on it, and the result. What
  /// belongs to a mesh lives and dies with its cycle.
  class Cycle
  {
  public:
    /// @param number  from 1
    Cycle(unsigned int                              number,
          const Parameters                         &parameters,
          std::unique_ptr<dealii::Triangulation<2>> mesh);

    const PlateDiscretization &
    discretization() const
    {
      return plate.discretization();
    }

    const dealii::Triangulation<2> &
    mesh() const
    {
      return discretization().mesh();
    }

    /// Made when it is first asked for.
    const StressRecovery &
    recovery() const;

    const Parameters &parameters;
    PlateModel        plate;
    CycleResult       result;

  private:
    mutable std::optional<StressRecovery> stress_recovery;
  };
} // namespace PlateImpact
