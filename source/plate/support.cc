#include "plate_impact/plate/support.h"

#include "plate_impact/plate/plate_element.h"
#include "plate_impact/plate/plate_mesh.h"

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



  std::map<types::boundary_id, Support>
  supports_of(const PlateParameters &plate)
  {
    const Support &first = find_support(plate.supports.front().support),
                  &last  = find_support(plate.supports.back().support);
    if (plate.is_circle())
      return {{edge_round, first}};
    if (!plate.is_from_file())
      return {{edge_x, first}, {edge_y, last}};
    std::map<types::boundary_id, Support> supports;
    for (unsigned int edge = 0; edge < plate.file->edges.size(); ++edge)
      for (const EdgeSupports &named : plate.supports)
        if (named.edge.empty() || named.edge == plate.file->edges[edge])
          supports[edge_named + edge] = find_support(named.support);
    return supports;
  }



  const Support &
  symmetry_plane()
  {
    static const Support symmetry = {false, true, false};
    return symmetry;
  }
} // namespace PlateImpact
