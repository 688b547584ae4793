#include "plate_impact/transient/plate_response.h"

#include <deal.II/base/exceptions.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/transient/impactor_stepper.h"
#include "plate_impact/transient/plate_stepper.h"

namespace PlateImpact
{
  PlateResponse::PlateResponse(const NewmarkScheme      &scheme,
                               SemidiscreteSystem       &plate,
                               const ContactIntegration &integration)
    : scheme(scheme)
    , integration(integration)
    , reversed(scheme.n_steps)
  {
    Assert(scheme.conserves_energy(), dealii::ExcInternalError());
    PlateStepper stepper(scheme, plate);
    const double at_begin = integration.acts_at_begin() ? 1. : 0.;
    for (unsigned int step = 0; step < scheme.n_steps; ++step)
      {
        const double force = step == 0 ? 1. : 0.;
        // a force at the end of a step is one at the beginning of the next
        const double known =
          step == 1 ? integration.known_begin_force(/*force_at_begin=*/1.) : 0.;
        stepper.begin_step(known);
        stepper.end_step(at_begin * force, force);
        reversed[scheme.n_steps - 1 - step] = stepper.displacement();
      }
    if (!reversed.allFinite())
      throw ComputationError(
        "the response of the plate to a unit force is not finite; try a "
        "smaller Time/Time step");
  }



  double
  PlateResponse::displacement(const unsigned int j) const
  {
    return reversed[scheme.n_steps - 1 - j];
  }



  Impact
  PlateResponse::impact(const Contact     &contact,
                        const Impactor    &impactor,
                        const unsigned int n_steps) const
  {
    ImpactorStepper stepper(scheme, contact, integration, impactor);
    Impact          result;
    result.history.reserve(n_steps + 1);
    result.history.add(stepper.state());

    const double    compliance = reversed[scheme.n_steps - 1];
    Eigen::VectorXd forces(n_steps);
    unsigned int    n_forces = 0; // up to the last that is not zero
    double          energy   = 0.;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        const double begin = stepper.begin_step();
        const double w     = stepper.state().plate_displacement;
        const double free  = forces.head(n_forces).dot(
          reversed.segment(scheme.n_steps - 1 - step, n_forces));
        const double phi = stepper.contact_force(free, compliance);
        forces[step]     = phi;
        if (phi != 0.)
          n_forces = step + 1;
        const double w_end = free + compliance * phi;
        const double force_begin =
          begin + (integration.acts_at_begin() ? phi : 0.);
        energy += 0.5 * (force_begin + phi) * (w_end - w);
        stepper.end_step(phi, w_end, energy);
        result.history.add(stepper.state());
      }
    result.impulse         = stepper.impulse();
    result.n_contact_steps = stepper.n_contact_steps();
    return result;
  }
} // namespace PlateImpact
