#include "plate_impact/analysis/cycle.h"

#include "plate_impact/estimator/make_error_estimator.h"
#include "plate_impact/plate/plate_mesh.h"

#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  Cycle::Cycle(const unsigned int                number,
               const Parameters                 &parameters,
               std::unique_ptr<Triangulation<2>> mesh_of_quadrant)
    : parameters(parameters)
    , plate(parameters.plate,
            parameters.discretization,
            std::move(mesh_of_quadrant))
  {
    result.cycle              = number;
    result.cells              = mesh().n_active_cells();
    result.degrees_of_freedom = discretization().n_unknowns();
    result.min_cell_size      = smallest_cell_size(mesh());
    result.cell_size_at_load =
      cell_sizes_near_load(mesh(), parameters.impactor.contact_half_length())
        .second;
  }



  const StressRecovery &
  Cycle::recovery() const
  {
    if (!stress_recovery)
      stress_recovery.emplace(make_stress_recovery(parameters, mesh()));
    return *stress_recovery;
  }

} // namespace PlateImpact
