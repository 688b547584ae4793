#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Cells of a first mesh towards a load, at most: along a line that is much
    /// longer than wide they are too many.
    constexpr unsigned int most_cells_at_first = 5000;



    /// Refines cells that are larger than theta times their distance from the
    /// contact, again and again, as long as the maximum of cells allows it.
    /// @return whether the mesh is refined
    bool
    refine(Triangulation<2>           &mesh,
           const double                theta,
           const AdaptivityParameters &adaptivity,
           const double                contact_half_length)
    {
      for (bool is_refined = false;; is_refined = true)
        {
          bool is_marked = false;
          for (const auto &cell : mesh.active_cell_iterators())
            {
              const Point<2> centre = cell->center();
              const Point<2> nearest(std::clamp(centre[0],
                                                -contact_half_length,
                                                contact_half_length),
                                     0.);
              if (cell_size(cell) > theta * centre.distance(nearest) &&
                  !is_smallest(cell, adaptivity))
                {
                  cell->set_refine_flag();
                  is_marked = true;
                }
            }
          if (!is_marked)
            return is_refined;
          // with those that hanging nodes ask for
          mesh.prepare_coarsening_and_refinement();
          unsigned int n_cells = mesh.n_active_cells();
          for (const auto &cell : mesh.active_cell_iterators())
            n_cells += cell->refine_flag_set() ? 3 : 0;
          if (n_cells > adaptivity.maximum_cells)
            {
              for (const auto &cell : mesh.active_cell_iterators())
                cell->clear_refine_flag();
              return is_refined;
            }
          mesh.execute_coarsening_and_refinement();
        }
    }
  } // namespace



  bool
  refine_graded(const Adapting &adapting)
  {
    const AdaptivityParameters &adaptivity = adapting.adaptivity;
    // below that, cells far from the contact are at the minimum size as well
    const double smallest_theta = adaptivity.minimum_cell_size /
      (2. * adapting.mesh.n_active_cells() * adaptivity.maximum_cell_size);
    for (double theta = 1.; theta > smallest_theta; theta *= 0.5)
      if (refine(adapting.mesh,
                 theta,
                 adaptivity,
                 adapting.contact_half_length))
        return true;
    return false;
  }



  void
  refine_towards_load(Triangulation<2> &mesh, const Parameters &parameters)
  {
    AdaptivityParameters grading = parameters.adaptivity;
    // cells that may be halved are larger than the patch
    grading.minimum_cell_size = 0.5 *
      (parameters.contact.has_patch() ? parameters.contact.patch_radius :
                                        parameters.plate.thickness);
    grading.maximum_cells =
      std::min(grading.maximum_cells, most_cells_at_first);
    refine(mesh, 1., grading, parameters.impactor.contact_half_length());
  }
} // namespace PlateImpact
