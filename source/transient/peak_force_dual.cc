#include "plate_impact/transient/peak_force_dual.h"

#include <algorithm>

namespace PlateImpact
{
  DualLoads
  dual_loads(const ContactHistory &history,
             const NewmarkScheme  &scheme,
             const Contact        &contact,
             const Impactor       &impactor,
             const PlateResponse  &response)
  {
    const std::vector<ContactState> &states      = history.states();
    const ContactIntegration        &integration = scheme.integration;
    const Eigen::Index p = &history.peak() - states.data(); // step of the peak
    Eigen::VectorXd    compliance(p), phi(p);
    // d phi_k by the approaches at the begin (a) and at the end (b) of a step
    Eigen::VectorXd a = Eigen::VectorXd::Zero(p), b = a;
    Contact         followed = contact;
    double          at_peak  = 0.;
    for (Eigen::Index k = 0; k < p; ++k)
      {
        // the impactor's own: steps after one with the contact force 1
        const double in_steps =
          integration.acts_at_begin ? k + 0.5 : std::max(scheme.beta, 1. * k);
        compliance[k] = response.displacement(k) +
          scheme.dt * scheme.dt / impactor.mass * in_steps;
        const double begin = states[k].indentation,
                     end   = states[k + 1].indentation;
        phi[k]             = integration.force(followed, begin, end);
        if (phi[k] != 0.)
          b[k] = integration.stiffness(followed, begin, end, phi[k]) /
            followed.approach_derivative(end);
        // a mean force takes both ends alike
        if (phi[k] != 0. && integration.acts_at_begin)
          a[k] = integration.stiffness(followed, end, begin, phi[k]) /
            followed.approach_derivative(begin);
        at_peak = followed.stiffness(end) / followed.approach_derivative(end);
        followed.follow(end);
      }

    Eigen::VectorXd mu(p);
    double          y_after = 0.; // y = (R + R_m)^T mu of the step after
    for (Eigen::Index n = p - 1; n >= 0; --n)
      {
        const Eigen::Index n_after = p - 1 - n;
        const double       of_later =
          compliance.segment(1, n_after).dot(mu.tail(n_after));
        double right_hand_side = n == p - 1 ? at_peak : -a[n + 1] * y_after;
        right_hand_side -= b[n] * of_later;
        mu[n]   = right_hand_side / (1. + b[n] * compliance[0]);
        y_after = of_later + compliance[0] * mu[n];
      }
    return {phi, mu};
  }



  DualMotions
  dual_motions(const DualLoads     &loads,
               const NewmarkScheme &scheme,
               SemidiscreteSystem  &plate,
               const unsigned int   most_times)
  {
    // Forces act in the middle of their steps and displacements are read at the
    // end: motion and dual motion belong together at times whose sum is half a
    // step more than that of the peak.
    const Eigen::Index p      = loads.forces.size(),
                       stride = 1 + (p - 1) / most_times;
    const Eigen::Index first = p % stride, n_times = p / stride + 1;
    DualMotions        result;
    result.weight = stride;
    result.motion.setZero(plate.load().size(), n_times);
    result.dual = result.motion;

    step_under(loads.forces,
               scheme,
               plate,
               [&](const Eigen::Index step, const PlateStepper &stepper) {
                 if (step % stride == first)
                   // stresses follow strains and, damped, their rates
                   result.motion.col(step / stride) =
                     stepper.unknowns() + plate.damping() * stepper.rates();
               });
    step_under(loads.weights.reverse(),
               scheme,
               plate,
               [&](const Eigen::Index step, const PlateStepper &stepper) {
                 const auto column = [&](const Eigen::Index beside) {
                   return result.dual.col(n_times - 1 - beside / stride);
                 };
                 if (step % stride == 0 && step < p)
                   column(step) += 0.5 * stepper.unknowns();
                 if ((step - 1) % stride == 0)
                   column(step - 1) += 0.5 * stepper.unknowns();
               });
    return result;
  }
} // namespace PlateImpact
