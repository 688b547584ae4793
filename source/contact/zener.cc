#include "plate_impact/contact/zener.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_solver.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// The force at a point that moves an infinite thin plate at unit velocity.
    /// [N s/m]
    double
    impedance(const PlateSection &section)
    {
      return 8. * std::sqrt(section.mean_bending_stiffness()) *
        std::sqrt(section.mass_per_area);
    }



    /// Steps of Zener's equation from first touch.
    class ZenerSteps
    {
    public:
      ZenerSteps(const Contact      &contact,
                 const Impactor     &impactor,
                 const PlateSection &section)
        : contact(contact)
        , mass(impactor.mass)
        , impedance(PlateImpact::impedance(section))
        , velocity(impactor.velocity)
      {}

      /// @return indentation at the end of the step [m]
      double
      advance(const double dt)
      {
        const double compliance = dt / impedance + dt * dt / (2. * mass);
        const double free       = approach + dt * velocity;
        const double force =
          solve_contact(step, contact, alpha, free, compliance);
        velocity -= dt / mass * force;
        approach = free - compliance * force;
        alpha    = contact.indentation_under(approach);
        contact.follow(alpha);
        return alpha;
      }

      const Contact &
      state() const
      {
        return contact;
      }

      double
      impactor_velocity() const
      {
        return velocity;
      }

    private:
      const ContactIntegration step = ForceIntegration::energy_conserving;
      Contact                  contact;
      const double             mass, impedance;
      double                   approach = 0., alpha = 0., velocity;
    };



    /// Neither the energy of the impactor nor the quasi-static balance F =
    /// impedance * v0 can be exceeded: the smaller of the two indentations is
    /// the length scale, a part of the time to cross it the step.
    double
    step_size(const Contact      &contact,
              const Impactor     &impactor,
              const PlateSection &section)
    {
      const ContactLaw &law = contact.first_loading();
      const double      v0  = impactor.velocity;
      double low = 0., high = law.indentation(impedance(section) * v0);
      // the first by bisection of the potential
      if (law.potential(high) > impactor.kinetic_energy())
        while (high - low > 1e-3 * high)
          {
            const double middle = 0.5 * (low + high);
            (law.potential(middle) > impactor.kinetic_energy() ? high : low) =
              middle;
          }
      return high / v0 / 150.;
    }
  } // namespace



  ZenerImpact::ZenerImpact(const Contact      &contact,
                           const Impactor     &impactor,
                           const PlateSection &section)
    : contact(contact)
    , impactor(impactor)
    , section(section)
    , peak(peak_in_steps(step_size(contact, impactor, section)))
  {}



  ContactState
  ZenerImpact::peak_in_steps(const double dt) const
  {
    ZenerSteps steps(contact, impactor, section);
    double     before = 0., alpha = 0.;
    for (unsigned int n = 1; n < 100000000; ++n)
      {
        const double next = steps.advance(dt);
        if (next <= alpha)
          {
            // the vertex of the parabola through the last three
            const double slope     = 0.5 * (next - before),
                         curve     = next - 2. * alpha + before;
            const double to_vertex = curve < 0. ? -slope / curve : 0.;
            const double at_peak   = alpha + 0.5 * slope * to_vertex;
            return {(n - 1 + to_vertex) * dt,
                    contact.first_loading().force(at_peak),
                    at_peak};
          }
        before = alpha;
        alpha  = next;
      }
    throw ComputationError("Zener's equation has no peak of the contact force");
  }



  ContactState
  ZenerImpact::peak_on_rigid_plate() const
  {
    PlateSection immovable = section;
    immovable.mass_per_area *= 1e12;
    return ZenerImpact(contact, impactor, immovable).peak;
  }



  ContactHistory
  ZenerImpact::history(const double end_time) const
  {
    const double   shortest = step_size(contact, impactor, section);
    ZenerSteps     steps(contact, impactor, section);
    ContactHistory history;
    ContactState   state;
    state.impactor_velocity = impactor.velocity;
    history.add(state);
    for (double dt = shortest; state.time < end_time && state.overlap() >= 0.;)
      {
        const double before = state.indentation, v = state.impactor_velocity;
        state.indentation           = steps.advance(dt);
        state.force                 = steps.state().force(state.indentation);
        state.permanent_indentation = steps.state().dent();
        state.impactor_velocity     = steps.impactor_velocity();
        state.impactor_displacement += 0.5 * dt * (v + state.impactor_velocity);
        state.plate_displacement =
          state.impactor_displacement - state.indentation;
        state.time += dt;
        history.add(state);
        // what follows the first touch may be slow
        dt = std::clamp(0.002 * state.indentation * dt /
                          std::abs(state.indentation - before),
                        shortest,
                        1.01 * dt);
      }
    return history;
  }



  double
  ZenerImpact::restitution() const
  {
    const double shortest = step_size(contact, impactor, section);
    ZenerSteps   steps(contact, impactor, section);
    double       dt = shortest, alpha = 0.;
    while (true)
      {
        const double next = steps.advance(dt);
        if (next <= steps.state().dent())
          return -steps.impactor_velocity() / impactor.velocity;
        // past the peak of a heavily damped impact the indentation creeps back
        const double slow = 0.002 * next * dt / std::abs(next - alpha);
        dt                = std::clamp(slow, shortest, 1.01 * dt);
        alpha             = next;
        const double v    = steps.impactor_velocity();
        if (steps.state().stored_energy(alpha) + 0.5 * impactor.mass * v * v <
            1e-6 * impactor.kinetic_energy())
          return 0.;
      }
  }



  std::optional<double>
  ZenerImpact::loss_factor() const
  {
    const std::optional<double> k = contact.first_loading().hertz_coefficient();
    if (!k)
      return {};
    const double m = impactor.mass;
    const double T = std::pow(m / (*k * std::sqrt(impactor.velocity)), 0.4);
    return m / (impedance(section) * T);
  }



  double
  ZenerImpact::chosen_time_step(const TimeParameters &time) const
  {
    const double pi = std::acos(-1.);
    // by powers of two from a time of the plate alone, the inverse frequency of
    // thickness shear, so that impactors share steps
    const double base =
      std::sqrt(section.rotary_inertia / section.mean_shear_stiffness());
    double step =
      base * std::exp2(std::floor(std::log2(contact_time() / 8. / base)));
    // the reference is good to about 1e-5
    const double tolerance = std::max(time.step_tolerance, 1e-5);
    while (true)
      {
        step *= 0.5;
        // the largest step misses the peak of a half sine by up to half a step
        const double missed = 1. - std::cos(0.5 * pi * step / contact_time());
        const double changed =
          std::abs(peak_in_steps(step).force / peak.force - 1.);
        if (std::max(missed, changed) <= tolerance)
          return time.end_time > 0. ? std::min(step, time.end_time) : step;
      }
  }



  BendingWave
  ZenerImpact::wave_of(const double contact_time) const
  {
    const double pi        = std::acos(-1.);
    const double frequency = pi / contact_time;
    const double speed     = std::sqrt(frequency) *
      std::pow(section.mean_bending_stiffness() / section.mass_per_area, 0.25);
    return {2. * contact_time * speed, 2. * speed};
  }
} // namespace PlateImpact
