#ifndef plate_impact_plate_snapshot_h
#define plate_impact_plate_snapshot_h

#include <Eigen/Core>

namespace PlateImpact
{
  /// State of the plate kept for output.
  struct Snapshot
  {
    double          time; ///< [s]
    Eigen::VectorXd unknowns;
  };
} // namespace PlateImpact

#endif
