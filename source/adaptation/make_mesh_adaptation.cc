#include <deal.II/grid/grid_refinement.h>
#include <deal.II/lac/vector.h>

#include "plate_impact/adaptation/graded_refinement.h"
#include "plate_impact/adaptation/hanging_nodes.h"
#include "plate_impact/adaptation/remeshing.h"

#include <limits>
#include <stdexcept>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    class KeptMesh : public MeshAdaptation
    {
    public:
      using MeshAdaptation::MeshAdaptation;

      bool
      adapt(Triangulation<2> &,
            const ErrorRatios &,
            std::vector<std::string> &) const override
      {
        return false;
      }
    };



    /// Refines every cell, whatever its error, unless one is at the minimum
    /// size.
    class UniformRefinement : public MeshAdaptation
    {
    public:
      using MeshAdaptation::MeshAdaptation;

      bool
      adapt(Triangulation<2> &mesh,
            const ErrorRatios &,
            std::vector<std::string> &) const override
      {
        for (const auto &cell : mesh.active_cell_iterators())
          if (is_smallest(cell, adaptivity))
            return false;
        mesh.refine_global();
        return true;
      }
    };



    /// Refines the cells with the largest errors and coarsens those with the
    /// smallest, one level a cycle: those that together hold a share of the
    /// squared error (Doerfler 1996, doi:10.1137/0733054), or a share of the
    /// cells.
    class RankedRefinement : public MeshAdaptation
    {
    public:
      using MeshAdaptation::MeshAdaptation;

      bool
      adapt(Triangulation<2>  &mesh,
            const ErrorRatios &error,
            std::vector<std::string> &) const override
      {
        // Cells that may not be refined, and ought not to be coarsened, stay as
        // they are. Under a point load they would have all of the share.
        const auto is_settled = [&](const auto &cell) {
          return error.elements[cell->active_cell_index()] >= 1. &&
            is_smallest(cell, adaptivity);
        };
        const std::vector<CellId> before = sorted_cells(mesh);
        Vector<double> criteria(error.elements.begin(), error.elements.end());
        for (const auto &cell : mesh.active_cell_iterators())
          if (is_settled(cell))
            criteria[cell->active_cell_index()] = 0.;
        if (adaptivity.strategy == AdaptationStrategy::fixed_fraction)
          GridRefinement::refine_and_coarsen_fixed_fraction(
            mesh,
            criteria,
            adaptivity.refined_share_of_error,
            adaptivity.coarsened_share_of_error,
            std::numeric_limits<unsigned int>::max(),
            VectorTools::L2_norm);
        else
          GridRefinement::refine_and_coarsen_fixed_number(
            mesh,
            criteria,
            adaptivity.refined_share_of_cells,
            adaptivity.coarsened_share_of_cells);
        for (const auto &cell : mesh.active_cell_iterators())
          {
            if (is_smallest(cell, adaptivity))
              cell->clear_refine_flag();
            if (is_settled(cell))
              cell->clear_coarsen_flag();
          }
        mesh.execute_coarsening_and_refinement();
        return sorted_cells(mesh) != before;
      }
    };



    template <typename Strategy>
    std::unique_ptr<const MeshAdaptation>
    make(const AdaptivityParameters &adaptivity, const double half_length)
    {
      return std::make_unique<Strategy>(adaptivity, half_length);
    }



    const std::vector<std::pair<AdaptationStrategy, decltype(&make<KeptMesh>)>>
      strategies = {
        {AdaptationStrategy::none, make<KeptMesh>},
        {AdaptationStrategy::hanging_nodes, make<HangingNodeAdaptation>},
        {AdaptationStrategy::remeshing, make<Remeshing>},
        {AdaptationStrategy::fixed_fraction, make<RankedRefinement>},
        {AdaptationStrategy::fixed_number, make<RankedRefinement>},
        {AdaptationStrategy::uniform, make<UniformRefinement>},
        {AdaptationStrategy::graded, make<GradedRefinement>}};
  } // namespace



  std::unique_ptr<const MeshAdaptation>
  make_mesh_adaptation(const AdaptivityParameters &adaptivity,
                       const double                contact_half_length)
  {
    for (const auto &[strategy, maker] : strategies)
      if (strategy == adaptivity.strategy)
        return maker(adaptivity, contact_half_length);
    throw std::logic_error("no such strategy");
  }
} // namespace PlateImpact
