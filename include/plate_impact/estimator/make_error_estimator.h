#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/estimator/error_estimator.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"

#include <memory>

namespace PlateImpact
{
  /// The recovery for a scene's load.
  StressRecovery
  make_stress_recovery(const Parameters               &parameters,
                       const dealii::Triangulation<2> &mesh);

  /// The estimator that the scene names: `SPR` or `Kelly`. Discretization and
  /// recovery must outlive it.
  /// @param kept_interval  as in EnergyNormEstimator
  std::unique_ptr<ErrorEstimator>
  make_error_estimator(const Parameters          &parameters,
                       const PlateDiscretization &discretization,
                       const StressRecovery      &recovery,
                       unsigned int               kept_interval);
} // namespace PlateImpact
