#include "plate_impact/analysis/expected_cost.h"

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/analysis/impact_analysis.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// By how much the number of cells is to grow.
    double
    growth_of(const Cycle &cycle)
    {
      const AdaptivityParameters &adaptivity = cycle.parameters.adaptivity;
      const CycleResult          &result     = cycle.result;
      if (adaptivity.is_for_peak_force())
        {
          const auto &bar = result.peak_force_bar;
          if (!bar || bar->total() <= adaptivity.target())
            return 1.;
          const double factor = bar->total() / adaptivity.target();
          // cells are halved once at least where a plate is not divided anew
          return result.waves_are_everywhere &&
              may_have_equal_cells(cycle.parameters) ?
            growth_for_late_peak(factor / aim_for_late_peak) :
            std::max(4., growth_for_late_peak(factor));
        }
      // Target sizes take about twice as many cells, since cells are halved and
      // sizes change slowly from cell to cell. Strategies without target sizes
      // need cells as eta needs them, and so do waves that are everywhere: what
      // they ask for becomes cells of one size. The factors are chosen on
      // random scenes (doc/make/error_bars.py).
      const double of_eta = result.error->eta / adaptivity.target_error;
      const double of_sizes =
        n_wanted_cells(cycle.mesh(), *result.error_ratios, adaptivity) /
        result.cells;
      return std::max(1.5,
                      result.waves_are_everywhere ? 2.4 * of_eta :
                        of_sizes == 1.            ? of_eta :
                                                    1.8 * of_sizes);
    }
  } // namespace



  ExpectedCost
  expected_cost(const Parameters &scene)
  {
    Parameters            two_meshes = scene;
    AdaptivityParameters &adaptivity = two_meshes.adaptivity;
    adaptivity.maximum_cycles        = std::min(2u, adaptivity.maximum_cycles);
    ImpactAnalysis     analysis(two_meshes, nullptr, Wanted{true, false, 0});
    const Outcome      outcome = analysis.run();
    const CycleResult &result  = analysis.last_cycle().result;
    ExpectedCost       cost    = {1. * result.cells, 1. * result.steps};
    if (outcome != Outcome::maximum_cycles ||
        scene.adaptivity.maximum_cycles <= 2)
      return cost; // that of the whole run
    cost.cells = std::min(growth_of(analysis.last_cycle()) * cost.cells,
                          1. * adaptivity.maximum_cells);
    // The step falls until its error, that of average acceleration, keeps to
    // its share.
    if (adaptivity.is_for_peak_force() && scene.time.step_is_chosen &&
        result.time_error)
      cost.steps *= std::max(1.,
                             std::sqrt(*result.time_error /
                                       (share_of_step * adaptivity.target())));
    return cost;
  }
} // namespace PlateImpact
