#include "plate_impact/support.h"

#include "plate_impact/plate_element.h"

#include <stdexcept>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    const std::vector<Support> supports = {
      {"clamped", true, true, true},
      {"simply supported", true, false, true},
      {"soft simply supported", true, false, false},
      {"free", false, false, false}};
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



  std::vector<std::string>
  support_names()
  {
    std::vector<std::string> names;
    for (const Support &support : supports)
      names.push_back(support.name);
    return names;
  }



  const Support &
  find_support(const std::string &name)
  {
    for (const Support &support : supports)
      if (support.name == name)
        return support;
    throw std::logic_error("no support named " + name);
  }



  const Support &
  symmetry_plane()
  {
    static const Support symmetry = {"symmetry", false, true, false};
    return symmetry;
  }
} // namespace PlateImpact
