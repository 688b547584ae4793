#include "plate_impact/transient/integrator.h"

#include "plate_impact/transient/time_stepper.h"

namespace PlateImpact
{

  Impact
  Integrator::impact(SemidiscreteSystem &system,
                     const Contact      &contact,
                     const Impactor     &impactor,
                     const unsigned int  n_steps)
  {
    const NewmarkScheme scheme(time);
    // the work of the force is the plate's energy where nothing dissipates it
    if (scheme.conserves_energy() && system.damping() == 0. &&
        system.is_linear())
      return response(system).impact(contact, impactor, n_steps);
    TimeStepper stepper(scheme, system, contact, integration, impactor);
    stepper.advance(n_steps);
    return stepper.impact();
  }



  const PlateResponse &
  Integrator::response(SemidiscreteSystem &system)
  {
    return responses
      .try_emplace(&system, NewmarkScheme(time), system, integration)
      .first->second;
  }

} // namespace PlateImpact
