#include "plate_impact/transient/make_integrator.h"

#include "plate_impact/transient/ritz_reduction.h"

#include <stdexcept>

namespace PlateImpact
{
  std::unique_ptr<Integrator>
  make_integrator(const TimeParameters     &time,
                  FullSystem               &full,
                  const ContactIntegration &integration,
                  bool                      needs_fields)
  {
    switch (time.integrator)
      {
        case IntegratorType::Newmark:
          return std::make_unique<NewmarkOnTheMesh>(full, time, integration);
        case IntegratorType::Ritz_vectors:
          return std::make_unique<RitzReduction>(full,
                                                 time,
                                                 integration,
                                                 needs_fields);
      }
    throw std::logic_error("no such integrator");
  }
} // namespace PlateImpact
