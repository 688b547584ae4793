#ifndef plate_impact_transient_make_integrator_h
#define plate_impact_transient_make_integrator_h

#include "plate_impact/transient/integrator.h"

#include <memory>

namespace PlateImpact
{
  /// The integrator that the scene names: `Newmark` or `Ritz vectors`. System
  /// and integration must outlive it.
  /// @param needs_fields  whether more than the force is to be right
  std::unique_ptr<Integrator>
  make_integrator(FullSystem               &full,
                  const TimeParameters     &time,
                  const ContactIntegration &integration,
                  bool                      needs_fields);
} // namespace PlateImpact

#endif
