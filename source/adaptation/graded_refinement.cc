#include "plate_impact/adaptation/graded_refinement.h"

#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Cells of a first mesh towards a load, at most: along a line that is much
    /// longer than wide they are too many.
    constexpr unsigned int most_cells_at_first = 5000;



    /// Whether the mesh has at most so many cells after the flagged ones, and
    /// those that hanging nodes ask for, are halved.
    bool
    may_be_refined(Triangulation<2> &mesh, const unsigned int most_cells)
    {
      mesh.prepare_coarsening_and_refinement();
      unsigned int n = mesh.n_active_cells();
      for (const auto &cell : mesh.active_cell_iterators())
        if (cell->refine_flag_set())
          n += 3;
      return n <= most_cells;
    }
  } // namespace



  GradedRefinement::GradedRefinement(const AdaptivityParameters &adaptivity,
                                     const double contact_half_length)
    : adaptivity(adaptivity)
    , contact_half_length(contact_half_length)
  {}



  bool
  GradedRefinement::refine(Triangulation<2> &mesh, const double theta) const
  {
    bool is_refined = false;
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
            is_refined = true;
          }
      }
    if (is_refined && !may_be_refined(mesh, adaptivity.maximum_cells))
      {
        for (const auto &cell : mesh.active_cell_iterators())
          cell->clear_refine_flag();
        return false;
      }
    if (is_refined)
      mesh.execute_coarsening_and_refinement();
    return is_refined;
  }



  bool
  GradedRefinement::adapt(Triangulation<2> &mesh,
                          const ErrorOverLimit &,
                          std::vector<std::string> &) const
  {
    // below that, cells far from the contact are at the minimum size as well
    const double smallest_theta = adaptivity.minimum_cell_size /
      (2. * mesh.n_active_cells() * adaptivity.maximum_cell_size);
    for (double theta = 1.; theta > smallest_theta; theta *= 0.5)
      if (refine(mesh, theta))
        {
          while (refine(mesh, theta))
            ;
          return true;
        }
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
    const GradedRefinement refinement(
      grading,
      parameters.impactor.contact_half_length());
    while (refinement.refine(mesh, 1.))
      ;
  }
} // namespace PlateImpact
