#include "plate_impact/analysis/observation.h"

namespace PlateImpact
{
  Wanted
  wanted_by(const Parameters &parameters)
  {
    return {parameters.needs_estimator(),
            parameters.output.write_report,
            parameters.output.field_samples};
  }
} // namespace PlateImpact
