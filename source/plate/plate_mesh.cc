#include "plate_impact/plate/plate_mesh.h"

#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q1.h>

namespace PlateImpact
{
  using namespace dealii;

  const Mapping<2> &
  curved_mapping()
  {
    static const MappingQ<2> mapping(2);
    return mapping;
  }



  const Mapping<2> &
  mapping_of(const Triangulation<2>::cell_iterator &cell)
  {
    if (cell->at_boundary())
      for (const auto &face : cell->face_iterators())
        if (face->manifold_id() != numbers::flat_manifold_id)
          return curved_mapping();
    return StaticMappingQ1<2>::mapping;
  }



  const Mapping<2> &
  mapping_of(const Triangulation<2> &mesh)
  {
    for (const types::manifold_id id : mesh.get_manifold_ids())
      if (id != numbers::flat_manifold_id)
        return curved_mapping();
    return StaticMappingQ1<2>::mapping;
  }

} // namespace PlateImpact
