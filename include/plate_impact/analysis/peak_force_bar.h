#ifndef plate_impact_analysis_peak_force_bar_h
#define plate_impact_analysis_peak_force_bar_h

#include "plate_impact/estimator/error_over_limit.h"
#include "plate_impact/estimator/peak_force_error.h"

#include <optional>

namespace PlateImpact
{
  /// Covers what the cells miss: calibrated on random scenes (doc/theory.md).
  constexpr double safety_of_bar = 1.55;

  /// How far the computed peak force may be from that of the equations, by mesh
  /// and time step, relative to it. The model is another matter.
  struct PeakForceBar
  {
    double space = 0., time = 0., vectors = 0.;

    /// All of them.
    double
    total() const;
  };

  /// The peak on a mesh, for the next one.
  struct PeakOnMesh
  {
    double                force = 0.; ///< [N]
    std::optional<double> space;      ///< of the bar
  };

  /// The sum of the absolute contributions of the cells times a factor that
  /// covers what they miss (doc/theory.md).
  double
  bar_of_mesh(const PeakForceError &estimate);

  /// The part of a bar that is the mesh's: bar_of_mesh(). Where the load is not
  /// resolved, no less than the change of the force from the mesh before, if
  /// that was more than the bar there; and empty on a first mesh, as is any
  /// estimate above a twentieth of the force there.
  /// @param resolves_load  whether cells at the load are no larger than it
  std::optional<double>
  peak_force_error_by_mesh(const PeakForceError            &estimate,
                           double                           peak,
                           const std::optional<PeakOnMesh> &before,
                           bool                             resolves_load);

  /// What every cell may have of a target: the same share. The ratio is that of
  /// the roots, which fall with the cell size as errors in the energy norm do.
  ErrorOverLimit
  error_over_limit(const PeakForceError &estimate, double target);
} // namespace PlateImpact

#endif
