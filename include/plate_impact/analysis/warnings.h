#ifndef plate_impact_analysis_warnings_h
#define plate_impact_analysis_warnings_h

#include <deal.II/grid/tria.h>

#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/impact_estimate.h"

#include <string>
#include <vector>

namespace PlateImpact
{
  /// What limits the trust in a result: sentences, each with numbers and
  /// advice.
  struct Warnings
  {
    std::vector<std::string> numerical; ///< mesh, time step, end time
    std::vector<std::string> model;     ///< where the impact leaves the model

    /// The quantity that passes its limit by most, over the limit; 1 or less
    /// inside of the model.
    double farthest_from_model = 0.;

    /// The numerical ones first.
    std::vector<std::string>
    all() const;
  };

  /// Where an impact leaves what the model can tell, on whatever mesh: the area
  /// of the load, deflection, yield, indentation.
  Warnings
  model_warnings(const Parameters &parameters, const CycleResult &result);

  /// The same, and where end time and time step leave the peak force open.
  Warnings
  impact_warnings(const Parameters     &parameters,
                  const CycleResult    &result,
                  const ImpactEstimate &expected);

  /// The same, and where the mesh leaves it open.
  Warnings
  reliability_warnings(const Parameters               &parameters,
                       const dealii::Triangulation<2> &mesh,
                       const CycleResult              &result,
                       const ImpactEstimate           &expected);
} // namespace PlateImpact

#endif
