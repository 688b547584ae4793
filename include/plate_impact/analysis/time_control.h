#ifndef plate_impact_analysis_time_control_h
#define plate_impact_analysis_time_control_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/transient/struck_plate.h"

#include <optional>

namespace PlateImpact
{
  /// How long a plate is watched on a mesh and in which steps. With the goal
  /// `energy norm` that is what the scene says. On the way to a peak force it
  /// is no longer than the peak takes, and in steps, where the program chooses
  /// them, that leave most of the target to the mesh; a mesh that meets the
  /// target is watched to the end, for a later force may be larger. The first
  /// mesh is as well: before waves are back from the edges a force has one
  /// peak, and a larger one later is the mesh's own; one after that is the
  /// impact's, and the window holds it from the beginning.
  class TimeControl
  {
  public:
    /// @param parameters  complete
    explicit TimeControl(const Parameters &parameters);

    /// The scene with the end time and the step of the next transient.
    Parameters
    next(StruckPlate &plate) const;

    /// Whether another transient is to follow on the same mesh.
    /// @param time_error    as estimated_time_error()
    /// @param mesh_error    of the peak force, relative to it
    /// @param is_met        whether the bar of the peak meets its target
    bool
    goes_on(const ContactHistory        &history,
            const std::optional<double> &time_error,
            double                       mesh_error,
            bool                         is_met);

    /// The next transient runs to its end.
    /// @return whether the one before did not
    bool
    watch_to_the_end();

    /// For another mesh.
    /// @param history  on the mesh before
    void
    begin_mesh(const ContactHistory &history);

  private:
    /// Whether the step was too coarse, and is now smaller.
    bool
    refine_step(const std::optional<double> &time_error, double mesh_error);

    const Parameters parameters;
    const bool       is_for_peak;
    double           step;           ///< [s]
    double           window = 0.;    ///< on the way to the peak [s]
    double           echo   = 0.;    ///< when waves are back [s]
    bool is_scouting        = false; ///< whether the end is looked at first
    bool is_whole;                   ///< whether the transient runs to its end
  };
} // namespace PlateImpact

#endif
