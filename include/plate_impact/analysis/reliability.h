#ifndef plate_impact_analysis_reliability_h
#define plate_impact_analysis_reliability_h

#include <deal.II/grid/tria.h>

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/analysis/model_warnings.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/zener.h"

namespace PlateImpact
{
  /// What model_warnings() says, and where end time and time step leave the
  /// peak force open.
  /// @param contact_time  expected [s]
  Warnings
  impact_warnings(const Parameters  &parameters,
                  double             contact_time,
                  const CycleResult &result);

  /// Where the result of a scene leaves what its model, mesh or step can tell.
  Warnings
  reliability_warnings(const Parameters               &parameters,
                       const dealii::Triangulation<2> &mesh,
                       const CycleResult              &result,
                       const ImpactEstimate           &expected);
} // namespace PlateImpact

#endif
