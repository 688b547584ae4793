#include "plate_impact/transient/integrator.h"

namespace PlateImpact
{
  Integrator::Integrator(const TimeParameters     &time,
                         const ContactIntegration &integration)
    : time(time)
    , integration(integration)
  {}



  unsigned int
  Integrator::n_vectors() const
  {
    return 0;
  }



  const PlateResponse &
  Integrator::response(SemidiscreteSystem &system)
  {
    return responses
      .try_emplace(&system, NewmarkScheme(time), system, integration)
      .first->second;
  }



  NewmarkOnTheMesh::NewmarkOnTheMesh(FullSystem               &full,
                                     const TimeParameters     &time,
                                     const ContactIntegration &integration)
    : Integrator(time, integration)
    , full(full)
  {}



  SemidiscreteSystem &
  NewmarkOnTheMesh::system_for(const Parameters &)
  {
    return full;
  }
} // namespace PlateImpact
