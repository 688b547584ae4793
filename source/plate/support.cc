#include "plate_impact/plate/support.h"

#include "plate_impact/plate/plate_element.h"

#include <stdexcept>
#include <utility>
#include <vector>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    const std::vector<std::pair<EdgeSupport, Support>> supports = {
      {EdgeSupport::clamped, {true, true, true}},
      {EdgeSupport::simply_supported, {true, false, true}},
      {EdgeSupport::soft_simply_supported, {true, false, false}},
      {EdgeSupport::free, {false, false, false}}};
  } // namespace



  ComponentMask
  Support::held_components(const bool normal_is_x) const
  {
    ComponentMask mask(n_components, false);
    mask.set(PlateImpact::deflection, deflection);
    mask.set(normal_is_x ? rotation_x : rotation_y, normal_rotation);
    mask.set(normal_is_x ? rotation_y : rotation_x, tangential_rotation);
    return mask;
  }



  const Support &
  find_support(const EdgeSupport name)
  {
    for (const auto &[its_name, support] : supports)
      if (its_name == name)
        return support;
    throw std::logic_error("no such support");
  }



  const Support &
  symmetry_plane()
  {
    static const Support symmetry = {false, true, false};
    return symmetry;
  }
} // namespace PlateImpact
