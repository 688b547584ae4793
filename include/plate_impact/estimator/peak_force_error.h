#ifndef plate_impact_estimator_peak_force_error_h
#define plate_impact_estimator_peak_force_error_h

#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/peak_force_dual.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <vector>

namespace PlateImpact
{
  /// Estimated error of the peak force by the mesh: computed less exact,
  /// relative to the peak.
  struct PeakForceError
  {
    /// What the cells contribute, by active index, with their signs.
    std::vector<double> cells;

    double
    sum() const;

    /// Of the absolute values: contributions of an assumed shear strain may
    /// have the wrong sign.
    double
    sum_of_absolutes() const;
  };

  /// The dual weighted residual of the peak force (Bangerth & Rannacher 2003,
  /// doi:10.1007/978-3-0348-7605-6), with the errors of both motions taken from
  /// patch recovery: sum over times of
  ///   int_i (sigma* - sigma)^T_motion D^-1 (sigma* - sigma)_dual.
  /// @param recovery  of the mesh
  /// @param system    that the motions are states of
  /// @param peak      [N]
  PeakForceError
  estimated_peak_force_error(const PlateDiscretization &discretization,
                             const StressRecovery      &recovery,
                             const SemidiscreteSystem  &system,
                             const DualMotions         &motions,
                             double                     peak);
} // namespace PlateImpact

#endif
