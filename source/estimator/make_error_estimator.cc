#include "plate_impact/estimator/energy_norm_estimator.h"
#include "plate_impact/estimator/kelly_estimator.h"
#include "plate_impact/plate/plate_geometry.h"

#include <array>
#include <cmath>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Cells nearer to a point load than half the thickness.
    std::vector<unsigned int>
    singular_cells(const Parameters &parameters, const Triangulation<2> &mesh)
    {
      std::vector<unsigned int> cells;
      if (parameters.contact.load_is_singular())
        for (const auto &cell : mesh.active_cell_iterators())
          if (cell->center().norm() < 0.5 * parameters.plate.thickness)
            cells.push_back(cell->active_cell_index());
      return cells;
    }



    using Estimator = std::unique_ptr<ErrorEstimator>;

    struct IndicatorRow
    {
      ErrorIndicator choice;
      std::string    word;
      /// @param by_recovery  says how large the error is
      Estimator (*make)(const PlateDiscretization &, Estimator by_recovery);
    };

    const std::vector<IndicatorRow> indicators = {
      {ErrorIndicator::SPR,
       "SPR",
       [](const PlateDiscretization &, Estimator by_recovery) {
         return by_recovery;
       }},
      {ErrorIndicator::Kelly,
       "Kelly",
       make_as<ErrorEstimator, KellyEstimator>}};
  } // namespace



  StressRecovery
  make_stress_recovery(const Parameters       &parameters,
                       const Triangulation<2> &mesh)
  {
    const double line        = parameters.contact.load_is_line() ?
             0.5 * parameters.impactor.length :
             -1.;
    const bool   is_interior = parameters.adaptivity.patches_are_interior;
    const std::array<bool, 2> mirrors =
      geometry_of(parameters.plate).is_symmetric;
    return StressRecovery(mesh, [=](const Point<2> &point) {
      const bool is_on_plane =
        (mirrors[0] && point[0] == 0.) || (mirrors[1] && point[1] == 0.);
      return (point[1] == 0. && std::abs(point[0]) <= line) ||
        (is_interior && is_on_plane);
    });
  }



  std::unique_ptr<ErrorEstimator>
  make_error_estimator(const Parameters          &parameters,
                       const PlateDiscretization &discretization,
                       const StressRecovery      &recovery,
                       const unsigned int         kept_interval)
  {
    auto by_recovery = std::make_unique<EnergyNormEstimator>(
      discretization,
      recovery,
      singular_cells(parameters, discretization.mesh()),
      parameters.adaptivity.singular_cells_count,
      kept_interval);
    return row_of(parameters.adaptivity.indicator, indicators)
      .make(discretization, std::move(by_recovery));
  }



  template <>
  const std::vector<Word<ErrorIndicator>>
    Choices<ErrorIndicator>::words = words_of(indicators);
} // namespace PlateImpact
