#include "plate_impact/comparison/comparison_control.h"

namespace PlateImpact
{
  namespace
  {
    constexpr unsigned int most_halvings          = 8;
    constexpr unsigned int enough_reference_cells = 4000;
  } // namespace



  std::optional<Outcome>
  HalvedTargets::check(const CycleResult &result)
  {
    n_halvings = 0;
    while (goal->error(result) <= target && tighten())
      ;
    return {};
  }



  bool
  HalvedTargets::tighten()
  {
    if (n_halvings == most_halvings)
      return false;
    ++n_halvings;
    target *= 0.5;
    return true;
  }



  std::optional<Outcome>
  ReferenceControl::check(const CycleResult &result)
  {
    if (result.error->eta <= 0.1 * adaptivity.target_error ||
        result.cells >= enough_reference_cells)
      return Outcome::target_reached;
    return HalvedTargets::check(result);
  }



  std::optional<Outcome>
  OneMesh::check(const CycleResult &)
  {
    return Outcome::single_mesh;
  }



  CurveControl::CurveControl(const Parameters            &parameters,
                             const IsEnough              &is_enough,
                             const std::function<bool()> &is_spent)
    : HalvedTargets(parameters.adaptivity)
    , maximum_cycles(parameters.comparison.maximum_cycles)
    , is_enough(is_enough)
    , is_spent(is_spent)
  {}



  std::optional<Outcome>
  CurveControl::check(const CycleResult &result)
  {
    if (is_spent())
      return Outcome::time_budget;
    if (is_enough(result))
      return Outcome::nearly_as_fine_as_the_reference;
    if (result.cycle == maximum_cycles)
      return Outcome::maximum_cycles;
    return HalvedTargets::check(result);
  }
} // namespace PlateImpact
