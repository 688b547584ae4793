#include "plate_impact/contact_solver.h"

#include "plate_impact/exceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace PlateImpact
{
  double
  CollocatedContact::known_begin_force(const double force_at_begin) const
  {
    return force_at_begin;
  }



  bool
  CollocatedContact::acts_at_begin() const
  {
    return false;
  }



  double
  CollocatedContact::force(const ContactLaw &law,
                           const double,
                           const double end) const
  {
    return law.force(end);
  }



  double
  CollocatedContact::stiffness(const ContactLaw &law,
                               const double,
                               const double end) const
  {
    return law.stiffness(end);
  }



  double
  EnergyConservingContact::known_begin_force(const double) const
  {
    return 0.;
  }



  bool
  EnergyConservingContact::acts_at_begin() const
  {
    return true;
  }



  double
  EnergyConservingContact::force(const ContactLaw &law,
                                 const double      begin,
                                 const double      end) const
  {
    return law.mean_force(begin, end);
  }



  double
  EnergyConservingContact::stiffness(const ContactLaw &law,
                                     const double      begin,
                                     const double      end) const
  {
    // The quotient is exact but cancels for close indentations; there half the
    // stiffness in the middle is its limit.
    const double distance = end - begin;
    if (std::abs(distance) < 1e-4 * (std::abs(begin) + std::abs(end)))
      return 0.5 * law.stiffness(0.5 * (begin + end));
    return std::max(0.,
                    (law.force(end) - law.mean_force(begin, end)) / distance);
  }



  std::unique_ptr<const ContactIntegration>
  make_contact_integration(const std::string &name)
  {
    if (name == "collocation")
      return std::make_unique<CollocatedContact>();
    if (name == "energy conserving")
      return std::make_unique<EnergyConservingContact>();
    throw std::logic_error("no contact integration named " + name);
  }



  double
  solve_contact(const ContactIntegration &integration,
                const ContactLaw         &law,
                const double              begin,
                const double              free,
                const double              compliance)
  {
    if (!std::isfinite(begin) || !std::isfinite(free) ||
        !std::isfinite(compliance))
      throw ComputationError("the indentation is not finite");

    double high = free;
    double phi  = integration.force(law, begin, high);
    if (phi == 0.)
      return 0.;
    double low = free - compliance * phi;

    const double scale     = std::max({std::abs(begin), std::abs(free)});
    const double tolerance = 4. * std::numeric_limits<double>::epsilon();
    double       alpha     = std::clamp(begin, low, high);
    for (unsigned int iteration = 0; iteration < 200; ++iteration)
      {
        phi                          = integration.force(law, begin, alpha);
        const double residual        = alpha + compliance * phi - free;
        (residual > 0. ? high : low) = alpha;

        double next = alpha -
          residual /
            (1. + compliance * integration.stiffness(law, begin, alpha));
        // written so that a NaN bisects
        if (!(next >= low && next <= high))
          next = 0.5 * (low + high);
        const bool converged =
          std::abs(next - alpha) <= tolerance * std::abs(next) ||
          std::abs(next - alpha) <=
            std::numeric_limits<double>::epsilon() * 1e-3 * scale;
        alpha = next;
        if (converged)
          return integration.force(law, begin, alpha);
      }
    throw ComputationError("the contact equation was not solved: indentation " +
                           std::to_string(alpha) + " m");
  }
} // namespace PlateImpact
