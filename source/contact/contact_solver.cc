#include "plate_impact/contact/contact_solver.h"

#include "plate_impact/base/exceptions.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace PlateImpact
{
  double
  ContactIntegration::stiffness(const Contact &contact,
                                const double   begin,
                                const double   end,
                                const double   force) const
  {
    if (!is_mean)
      return contact.stiffness(end);
    // The quotient is exact but cancels for close indentations; there half the
    // stiffness in the middle is its limit.
    const double distance = end - begin;
    if (std::abs(distance) < 1e-4 * (std::abs(begin) + std::abs(end)))
      return 0.5 * contact.stiffness(0.5 * (begin + end));
    return std::max(0.,
                    (contact.force(end) - force) *
                      contact.approach_derivative(end) /
                      (contact.approach(end) - contact.approach(begin)));
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
