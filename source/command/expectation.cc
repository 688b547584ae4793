#include "plate_impact/command/expectation.h"

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  PlateModel
  coarse_plate(const Parameters                  &parameters,
               const std::array<unsigned int, 2> &n_cells)
  {
    DiscretizationParameters discretization = parameters.discretization;
    discretization.element                  = ElementType::MITC9;
    return {parameters.plate,
            discretization,
            make_plate_mesh(parameters.plate, n_cells)};
  }



  CycleResult
  coarse_impact(const Parameters &scene, const ZenerImpact &expected)
  {
    std::array<unsigned int, 2> n_cells  = {{8, 8}};
    const auto                  geometry = geometry_of(scene.plate);
    // Zener's equation, which gives short waves, is of no help for a cylinder
    for (unsigned int d = 0; d < 2; ++d)
      if (scene.impactor.is_cylinder())
        n_cells[d] = static_cast<unsigned int>(
          std::clamp(2. * (geometry.end[d] - geometry.begin[d]) /
                         expected.wave().length +
                       1.,
                     8.,
                     32.));
    Parameters parameters      = scene;
    parameters.time.integrator = IntegratorType::Ritz_vectors;
    parameters.time.end_time   = 1.5 * expected.contact_time();
    PlateModel  plate          = coarse_plate(parameters, n_cells);
    CycleResult result;
    const bool  is_held  = std::isfinite(plate.static_compliance(scene));
    result.cells         = plate.discretization().mesh().n_active_cells();
    result.min_cell_size = smallest_cell_size(plate.discretization().mesh());
    while (true)
      {
        parameters.time.time_step = parameters.time.end_time / 96.;
        result.history = plate.under(parameters, false).strike().history;
        const bool is_long =
          parameters.time.end_time > 1e6 * expected.contact_time();
        if (result.history->end_of_impact(is_held) || is_long)
          return result;
        parameters.time.end_time *= 2.;
      }
  }



  Cost
  cost_by_two_meshes(Parameters parameters)
  {
    // by which the bar falls when every cell is halved: the median of random
    // heavy impactors, whose peaks are late (doc/make/error_bars.py)
    constexpr double fall_by_halved_cells = 9.;
    const bool       has_more = parameters.adaptivity.maximum_cycles > 2;
    parameters.adaptivity.maximum_cycles =
      std::min(2u, parameters.adaptivity.maximum_cycles);
    ImpactAnalysis    analysis(parameters, nullptr, Wanted{true, false, 0});
    AdaptationControl control(parameters.adaptivity);
    AnalysisListener  listener;
    analysis.run(control, listener);
    const CycleResult          &result     = analysis.last_cycle().result;
    const AdaptivityParameters &adaptivity = parameters.adaptivity;
    double                      cells      = result.cells;
    if (!has_more)
      return {cells, 1. * result.steps};
    if (!adaptivity.is_for_peak_force())
      cells *= std::max(1., result.error->eta / adaptivity.target_error);
    else if (result.peak_force_bar &&
             result.peak_force_bar->total() >
               adaptivity.target_peak_force_error)
      cells *= std::pow(4., // once at least
                        std::max(1.,
                                 std::log(result.peak_force_bar->total() /
                                          adaptivity.target_peak_force_error) /
                                   std::log(fall_by_halved_cells)));
    return {std::min(cells, 1. * adaptivity.maximum_cells), 1. * result.steps};
  }
} // namespace PlateImpact
