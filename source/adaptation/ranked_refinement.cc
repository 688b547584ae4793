#include "plate_impact/adaptation/ranked_refinement.h"

#include <deal.II/grid/grid_refinement.h>
#include <deal.II/lac/vector.h>

#include <limits>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Whether a cell stays as it is: it may not be refined and ought not to be
    /// coarsened.
    bool
    is_settled(const Triangulation<2>::active_cell_iterator &cell,
               const ErrorOverLimit                         &error,
               const AdaptivityParameters                   &adaptivity)
    {
      return error.elements[cell->active_cell_index()] >= 1. &&
        is_smallest(cell, adaptivity);
    }



    /// xi', without that of settled cells, which would have all of the share
    /// under a point load.
    Vector<double>
    criteria(const Triangulation<2>     &mesh,
             const ErrorOverLimit       &error,
             const AdaptivityParameters &adaptivity)
    {
      Vector<double> result(error.elements.begin(), error.elements.end());
      for (const auto &cell : mesh.active_cell_iterators())
        if (is_settled(cell, error, adaptivity))
          result[cell->active_cell_index()] = 0.;
      return result;
    }



    /// Refines and coarsens as flagged, no cell below the minimum size.
    bool
    execute(Triangulation<2>           &mesh,
            const ErrorOverLimit       &error,
            const AdaptivityParameters &adaptivity)
    {
      const std::vector<CellId> before = sorted_cells(mesh);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          if (is_smallest(cell, adaptivity))
            cell->clear_refine_flag();
          if (is_settled(cell, error, adaptivity))
            cell->clear_coarsen_flag();
        }
      mesh.execute_coarsening_and_refinement();
      return sorted_cells(mesh) != before;
    }
  } // namespace



  FixedFraction::FixedFraction(const AdaptivityParameters &adaptivity)
    : adaptivity(adaptivity)
  {}



  bool
  FixedFraction::adapt(Triangulation<2>     &mesh,
                       const ErrorOverLimit &error,
                       std::vector<std::string> &) const
  {
    GridRefinement::refine_and_coarsen_fixed_fraction(
      mesh,
      criteria(mesh, error, adaptivity),
      adaptivity.refined_share_of_error,
      adaptivity.coarsened_share_of_error,
      std::numeric_limits<unsigned int>::max(),
      VectorTools::L2_norm);
    return execute(mesh, error, adaptivity);
  }



  FixedNumber::FixedNumber(const AdaptivityParameters &adaptivity)
    : adaptivity(adaptivity)
  {}



  bool
  FixedNumber::adapt(Triangulation<2>     &mesh,
                     const ErrorOverLimit &error,
                     std::vector<std::string> &) const
  {
    GridRefinement::refine_and_coarsen_fixed_number(
      mesh,
      criteria(mesh, error, adaptivity),
      adaptivity.refined_share_of_cells,
      adaptivity.coarsened_share_of_cells);
    return execute(mesh, error, adaptivity);
  }
} // namespace PlateImpact
