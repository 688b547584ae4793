#include "plate_impact/transient/plate_response.h"

#include <deal.II/base/exceptions.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/transient/impactor_stepper.h"
#include "plate_impact/transient/plate_stepper.h"

namespace PlateImpact
{
  PlateResponse::PlateResponse(const NewmarkScheme &scheme,
                               SemidiscreteSystem  &plate)
    : scheme(scheme)
    , reversed(scheme.n_steps)
  {
    Assert(scheme.conserves_energy(), dealii::ExcInternalError());
    step_under(Eigen::VectorXd::Unit(scheme.n_steps, 0),
               scheme,
               plate,
               [this](const Eigen::Index step, const PlateStepper &stepper) {
                 reversed[reversed.size() - step] = stepper.displacement();
               });
    if (!reversed.allFinite())
      throw ComputationError(
        "the response of the plate to a unit force is not finite; try a "
        "smaller Time/Time step");
  }



  Impact
  PlateResponse::impact(const Contact     &contact,
                        const Impactor    &impactor,
                        const unsigned int n_steps) const
  {
    ImpactorStepper stepper(scheme, contact, impactor);
    const double    compliance = displacement(0);
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
          begin + (scheme.integration.acts_at_begin() ? phi : 0.);
        energy += 0.5 * (force_begin + phi) * (w_end - w);
        stepper.end_step(phi, w_end, energy);
      }
    return stepper.impact();
  }
} // namespace PlateImpact
