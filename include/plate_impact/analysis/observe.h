#ifndef plate_impact_analysis_observe_h
#define plate_impact_analysis_observe_h

#include "plate_impact/analysis/analysis_listener.h"
#include "plate_impact/analysis/cycle.h"
#include "plate_impact/analysis/observation.h"

namespace PlateImpact
{
  /// What a scene asks for.
  Wanted
  wanted_by(const Parameters &parameters);


  /// Strikes the plate of a cycle.
  /// @param impact    the scene with end time and step of the transient
  /// @param listener  told of stages and steps
  /// @throws ComputationError naming step and quantity
  Observation
  observe(Cycle            &cycle,
          const Parameters &impact,
          const Wanted     &wanted,
          AnalysisListener &listener);
} // namespace PlateImpact

#endif
