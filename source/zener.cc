#include "plate_impact/zener.h"

#include "plate_impact/contact_solver.h"
#include "plate_impact/exceptions.h"
#include "plate_impact/plate_section.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  ExpectedPeak
  zener_peak(const ContactLaw   &law,
             const Impactor     &impactor,
             const PlateSection &section)
  {
    const double impedance =
      8. * std::sqrt(section.bending_stiffness(0, 0) * section.mass);
    const double v0 = impactor.velocity;

    // Neither the energy of the impactor nor the quasi-static balance
    // F = impedance * v0 can be exceeded: the smaller of the two indentations
    // is the length scale. The first is found by bisection of the potential.
    double low = 0., high = law.indentation(impedance * v0);
    if (law.potential(high) > impactor.kinetic_energy())
      while (high - low > 1e-3 * high)
        {
          const double middle = 0.5 * (low + high);
          (law.potential(middle) > impactor.kinetic_energy() ? high : low) =
            middle;
        }
    return zener_peak(law, impactor, section, high / v0 / 500.);
  }



  ExpectedPeak
  zener_peak(const ContactLaw   &law,
             const Impactor     &impactor,
             const PlateSection &section,
             const double        dt)
  {
    const double impedance =
      8. * std::sqrt(section.bending_stiffness(0, 0) * section.mass);
    const double                  m = impactor.mass;
    const EnergyConservingContact step;
    const double compliance = dt / impedance + dt * dt / (2. * m);
    double       alpha = 0., velocity = impactor.velocity;
    for (unsigned int n = 1; n < 100000000; ++n)
      {
        const double free  = alpha + dt * velocity;
        const double force = solve_contact(step, law, alpha, free, compliance);
        const double next  = free - compliance * force;
        velocity -= dt / m * force;
        if (next <= alpha)
          return {law.force(alpha), alpha, (n - 1) * dt};
        alpha = next;
      }
    throw ComputationError("Zener's equation has no peak of the contact force");
  }



  BendingWave
  contact_wave(const PlateSection &section, const double contact_time)
  {
    const double pi        = std::acos(-1.);
    const double frequency = pi / contact_time;
    const double speed     = std::sqrt(frequency) *
      std::pow(section.bending_stiffness(0, 0) / section.mass, 0.25);
    return {2. * contact_time * speed, 2. * speed};
  }
} // namespace PlateImpact
