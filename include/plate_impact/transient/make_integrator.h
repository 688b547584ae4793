#ifndef plate_impact_transient_make_integrator_h
#define plate_impact_transient_make_integrator_h

#include "plate_impact/transient/integrator.h"

#include <memory>

namespace PlateImpact
{
  /// The integrator that the scene names: `Newmark` or `Ritz vectors`. System
  /// and integration must outlive it.
  std::unique_ptr<Integrator>
  make_integrator(const Parameters         &parameters,
                  FullSystem               &full,
                  const ContactIntegration &integration);
} // namespace PlateImpact

#endif
