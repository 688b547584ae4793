#include "plate_impact/plate/support.h"

#include "plate_impact/plate/plate_element.h"
#include "plate_impact/plate/plate_mesh.h"

#include <string>
#include <vector>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    struct SupportRow
    {
      EdgeSupport choice;
      std::string word;
      Support     support;
    };

    const std::vector<SupportRow> supports = {
      {EdgeSupport::clamped, "clamped", {true, true, true}},
      {EdgeSupport::simply_supported, "simply supported", {true, false, true}},
      {EdgeSupport::soft_simply_supported,
       "soft simply supported",
       {true, false, false}},
      {EdgeSupport::free, "free", {false, false, false}}};
  } // namespace



  template <>
  const std::vector<Word<EdgeSupport>>
    Choices<EdgeSupport>::words = words_of(supports);



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
    return row_of(name, supports).support;
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
