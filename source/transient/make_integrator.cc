#include "plate_impact/transient/make_integrator.h"

#include "plate_impact/transient/ritz_reduction.h"

#include <stdexcept>

namespace PlateImpact
{
  std::unique_ptr<Integrator>
  make_integrator(const Parameters         &parameters,
                  FullSystem               &full,
                  const ContactIntegration &integration)
  {
    switch (parameters.time.integrator)
      {
        case IntegratorType::Newmark:
          return std::make_unique<NewmarkOnTheMesh>(full,
                                                    parameters.time,
                                                    integration);
        case IntegratorType::Ritz_vectors:
          return std::make_unique<RitzReduction>(full,
                                                 parameters.plate,
                                                 parameters.time,
                                                 integration,
                                                 parameters.needs_estimator());
      }
    throw std::logic_error("no such integrator");
  }
} // namespace PlateImpact
