#include "plate_impact/adaptation/uniform_refinement.h"

namespace PlateImpact
{
  using namespace dealii;

  UniformRefinement::UniformRefinement(const AdaptivityParameters &adaptivity)
    : adaptivity(adaptivity)
  {}



  bool
  UniformRefinement::adapt(Triangulation<2> &mesh,
                           const ErrorOverLimit &,
                           std::vector<std::string> &) const
  {
    for (const auto &cell : mesh.active_cell_iterators())
      if (is_smallest(cell, adaptivity))
        return false;
    mesh.refine_global();
    return true;
  }
} // namespace PlateImpact
