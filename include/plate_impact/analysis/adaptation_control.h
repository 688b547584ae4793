#ifndef plate_impact_analysis_adaptation_control_h
#define plate_impact_analysis_adaptation_control_h

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/analysis/outcome.h"
#include "plate_impact/base/parameters.h"

#include <optional>

namespace PlateImpact
{
  /// Whether the bar of the peak force meets its target.
  bool
  meets_force_target(const CycleResult          &result,
                     const AdaptivityParameters &adaptivity);


  /// What the goal makes smaller by better meshes: eta, or the mesh's part of
  /// the error of the peak force, infinite where it cannot be estimated.
  double
  error_of_goal(const CycleResult          &result,
                const AdaptivityParameters &adaptivity);


  /// When an analysis ends and what its next mesh is made for: by default, as
  /// Table 1 of the paper, when the scene's target error is met by the whole
  /// and by every cell that may still be refined.
  class AdaptationControl
  {
  public:
    explicit AdaptationControl(const AdaptivityParameters &adaptivity);

    virtual ~AdaptationControl() = default;

    /// Why the analysis ends with this cycle; empty when it goes on.
    virtual std::optional<Outcome>
    check(const CycleResult &result);

    /// Where the target gives no other mesh: whether there is a smaller one to
    /// try, which target_error() then is.
    virtual bool
    tighten();

    /// The error that the next mesh is made for.
    double
    target_error() const;

  private:
    bool
    is_met(const CycleResult &result) const;
    /// Whether it is not the mesh that keeps the peak force from its target.
    bool
    step_is_too_coarse(const CycleResult &result) const;

  protected:
    const AdaptivityParameters adaptivity;
    double                     target;
  };
} // namespace PlateImpact

#endif
