#ifndef plate_impact_comparison_comparison_control_h
#define plate_impact_comparison_comparison_control_h

#include "plate_impact/analysis/adaptation_control.h"
#include "plate_impact/base/parameters.h"

#include <functional>
#include <optional>

namespace PlateImpact
{
  /// Goes on to smaller errors: whenever that of the goal meets the target, or
  /// the target gives no other mesh, it is halved, up to eight times from one
  /// mesh to the next.
  class HalvedTargets : public AdaptationControl
  {
  public:
    using AdaptationControl::AdaptationControl;

    std::optional<Outcome>
    check(const CycleResult &result) override;

    bool
    tighten() override;

  private:
    unsigned int n_halvings = 0; ///< since the last cycle
  };


  /// Until the mesh, halved once more, makes a reference: at a tenth of the
  /// target, which the estimator's limits on long transients may put out of
  /// reach, or at 4000 cells.
  class ReferenceControl : public HalvedTargets
  {
  public:
    using HalvedTargets::HalvedTargets;

    std::optional<Outcome>
    check(const CycleResult &result) override;
  };


  /// One cycle.
  class OneMesh : public AdaptationControl
  {
  public:
    using AdaptationControl::AdaptationControl;

    std::optional<Outcome>
    check(const CycleResult &result) override;
  };


  /// For a curve of a comparison.
  class CurveControl : public HalvedTargets
  {
  public:
    using IsEnough = std::function<bool(const CycleResult &)>;

    /// @param is_enough  whether nothing can be learned from a smaller error
    /// @param is_spent   whether the time budget is
    CurveControl(const Parameters            &parameters,
                 const IsEnough              &is_enough,
                 const std::function<bool()> &is_spent);

    std::optional<Outcome>
    check(const CycleResult &result) override;

  private:
    const unsigned int          maximum_cycles;
    const IsEnough              is_enough;
    const std::function<bool()> is_spent;
  };
} // namespace PlateImpact

#endif
