#ifndef plate_impact_analysis_reliability_h
#define plate_impact_analysis_reliability_h

#include <deal.II/grid/tria.h>

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/base/parameters.h"

#include <string>
#include <vector>

namespace PlateImpact
{
  /// Where an impact leaves what the model can tell, on whatever mesh: the area
  /// of the load, deflection, yield, indentation.
  std::vector<std::string>
  model_warnings(const Parameters &parameters, const CycleResult &result);

  /// These, and where end time and time step leave the peak force open.
  /// @param contact_time  expected [s]
  std::vector<std::string>
  impact_warnings(const Parameters  &parameters,
                  double             contact_time,
                  const CycleResult &result);

  /// Where the result of a scene leaves what its model, mesh or step can tell:
  /// a sentence each, with numbers and advice. Empty for a result without an
  /// impactor.
  std::vector<std::string>
  reliability_warnings(const Parameters               &parameters,
                       const dealii::Triangulation<2> &mesh,
                       const CycleResult              &result);
} // namespace PlateImpact

#endif
