#include "plate_impact/contact/contact.h"

#include "plate_impact/base/exceptions.h"

#include <fmt/format.h>

namespace PlateImpact
{
  Contact::Contact(std::shared_ptr<const ContactLaw> first_law,
                   const double                      compliance,
                   std::shared_ptr<const Unloading>  memory)
    : law(std::move(first_law))
    , unloading(std::move(memory))
    , compliance(compliance)
  {
    if (compliance >= 0.)
      return;
    const double limit = zero_of([&](const double alpha) {
      // C F' = -0.9, of the steepest that the contact has up to there
      double slope = law->stiffness(alpha);
      if (unloading != nullptr)
        slope = std::max(slope,
                         unloading->power(alpha) * law->force(alpha) /
                           (alpha - unloading->dent(alpha)));
      return slope * compliance / -0.9 - 1.;
    });
    largest_force      = law->force(limit);
    law                = std::make_shared<TangentBeyond>(law, limit);
  }



  double
  Contact::mean_force(const double a, const double b) const
  {
    if (a == b)
      return force(a);
    const double low = std::min(a, b), high = std::max(a, b);
    // by the means of what is followed between the two
    const auto mean = [&](const auto mean_of) {
      double begin = low, sum = 0.;
      for (const UnloadingCurve *curve : {&unload, &reload})
        if (const double end = std::min(high, curve->end); begin < end)
          {
            sum += (curve->*mean_of)(begin - curve->dent, end - curve->dent) *
              (end - begin);
            begin = end;
          }
      if (begin < high)
        sum += ((*law).*mean_of)(begin, high) * (high - begin);
      return sum / (high - low);
    };
    const double over_indentation = mean(&ContactLaw::mean_force);
    if (compliance == 0.)
      return over_indentation;
    // change of the energies over that of the approach, both divided by the
    // change of the indentation, so that nothing cancels
    const double slope = mean(&ContactLaw::mean_stiffness);
    return (over_indentation +
            0.5 * compliance * (force(a) + force(b)) * slope) /
      (1. + compliance * slope);
  }



  double
  Contact::indentation_under(const double approach) const
  {
    if (compliance == 0. || approach <= dent())
      return approach;
    double low = dent(), high = std::numeric_limits<double>::infinity();
    for (const double end : {unload.end, reload.end})
      if (approach >= this->approach(end))
        low = std::max(low, end);
      else
        high = std::min(high, end);
    // Within a branch the force is convex: Newton's method comes from one side,
    // from below with C < 0, from above with C > 0.
    double alpha =
      compliance < 0. ? std::max(approach, low) : std::min(approach, high);
    for (unsigned int iteration = 0; iteration < 100; ++iteration)
      {
        const double step =
          (approach - this->approach(alpha)) / approach_derivative(alpha);
        alpha += step;
        // what a step leaves is of the order of its square, or round-off
        if (std::abs(step) <= 1e-9 * (alpha - dent()) + 4e-16 * alpha)
          break;
      }
    return alpha;
  }



  void
  Contact::follow(const double indentation)
  {
    if (unloading == nullptr)
      return;
    dissipated = dissipated_energy(indentation);
    last       = indentation;

    // unloading begins at the end of a step, unless the bodies have parted
    if (indentation <= dent())
      unload.end = dent();
    else if (indentation > unload.end)
      {
        unload.end_force = force(indentation);
        unload.end       = indentation;
        if (indentation > reload.end)
          {
            unload.dent  = unloading->dent(indentation);
            unload.power = unloading->power(indentation);
            reload       = unload;
            reload.power = unloading->reloading_power(indentation);
          }
      }
  }



  double
  solve_contact(const ContactIntegration &integration,
                const Contact            &contact,
                const double              begin,
                const double              free,
                const double              compliance)
  {
    if (!std::isfinite(begin) || !std::isfinite(free) ||
        !std::isfinite(compliance))
      throw ComputationError("the indentation is not finite");

    // phi is never negative and never decreases: the root lies between these
    double high = contact.indentation_under(free);
    double phi  = integration.force(contact, begin, high);
    if (phi == 0.)
      return 0.;
    double low = contact.indentation_under(free - compliance * phi);

    const double epsilon = std::numeric_limits<double>::epsilon();
    double       alpha   = std::clamp(begin, low, high);
    for (unsigned int iteration = 0; iteration < 2000; ++iteration)
      {
        phi                   = integration.force(contact, begin, alpha);
        const double approach = contact.approach(alpha);
        const double residual = approach + compliance * phi - free;
        // what round-off leaves of the residual, or nothing left to bisect
        if (std::abs(residual) <= 2. * epsilon *
                (std::abs(alpha) + compliance * phi + std::abs(free)) ||
            high - low <= 2. * epsilon * (std::abs(low) + std::abs(high)))
          return phi;

        (residual > 0. ? high : low) = alpha;
        const double newton          = alpha -
          residual /
            (contact.approach_derivative(alpha) +
             compliance * integration.stiffness(contact, begin, alpha, phi));
        // strictly within the bracket, or else its middle; a NaN bisects
        alpha =
          newton > low && newton < high ? newton : low + 0.5 * (high - low);
      }
    throw ComputationError(
      fmt::format("the contact equation was not solved (indentation {} m, "
                  "force {} N); try a smaller Time/Time step",
                  alpha,
                  phi));
  }
} // namespace PlateImpact
