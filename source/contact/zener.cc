#include "plate_impact/contact/zener.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/contact/hertz_law.h"

#include <algorithm>

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
    struct ZenerSteps
    {
      Contact      contact;
      Impactor     impactor;
      const double impedance;
      double       approach = 0., alpha = 0.;

      /// @return indentation at the end of the step [m]
      double
      advance(const double dt)
      {
        const double compliance =
          dt / impedance + dt * dt / (2. * impactor.mass);
        const double free  = approach + dt * impactor.velocity;
        const double force = solve_contact(ForceIntegration::energy_conserving,
                                           contact,
                                           alpha,
                                           free,
                                           compliance);
        impactor.velocity -= dt / impactor.mass * force;
        approach = free - compliance * force;
        alpha    = contact.indentation_under(approach);
        contact.follow(alpha);
        return alpha;
      }
    };



    /// Neither the energy of the impactor nor the quasi-static balance F =
    /// impedance * v0 can be exceeded: the smaller of the two indentations is
    /// the length scale, a part of the time to cross it the step.
    double
    step_size(const ZenerImpact &impact)
    {
      const ContactLaw &law    = impact.contact.first_loading();
      const double      v0     = impact.impactor.velocity;
      const double      energy = impact.impactor.kinetic_energy();
      double low = 0., high = law.indentation(impedance(impact.section) * v0);
      // the first by bisection of the potential
      if (law.potential(high) > energy)
        while (high - low > 1e-3 * high)
          {
            const double middle                           = 0.5 * (low + high);
            (law.potential(middle) > energy ? high : low) = middle;
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
    , peak(peak_in_steps(step_size(*this)))
  {}



  ContactState
  ZenerImpact::peak_in_steps(const double dt) const
  {
    ZenerSteps steps{contact, impactor, impedance(section)};
    double     before = 0.;
    for (unsigned int n = 1; n < 100000000; ++n)
      {
        const double alpha = steps.alpha, next = steps.advance(dt);
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
      }
    throw ComputationError("Zener's equation has no peak of the contact force");
  }



  ContactHistory
  ZenerImpact::history(const double end_time) const
  {
    const double   shortest = step_size(*this);
    ZenerSteps     steps{contact, impactor, impedance(section)};
    ContactHistory history;
    ContactState   state;
    state.impactor_velocity = impactor.velocity;
    history.states.push_back(state);
    // without an end, a plate that gives way takes all of the energy
    const double least_energy =
      std::isinf(end_time) ? 1e-6 * impactor.kinetic_energy() : 0.;
    for (double dt = shortest; state.time < end_time && state.overlap() >= 0. &&
         steps.impactor.kinetic_energy() +
             steps.contact.stored_energy(state.indentation) >=
           least_energy;)
      {
        const double before = state.indentation, v = state.impactor_velocity;
        state.indentation           = steps.advance(dt);
        state.force                 = steps.contact.force(state.indentation);
        state.permanent_indentation = steps.contact.dent();
        state.impactor_velocity     = steps.impactor.velocity;
        state.impactor_displacement += 0.5 * dt * (v + state.impactor_velocity);
        state.plate_displacement =
          state.impactor_displacement - state.indentation;
        state.time += dt;
        history.states.push_back(state);
        // what follows the first touch may be slow
        dt = std::clamp(0.002 * state.indentation * dt /
                          std::abs(state.indentation - before),
                        shortest,
                        1.01 * dt);
      }
    return history;
  }



  std::optional<double>
  ZenerImpact::loss_factor() const
  {
    const auto *law = dynamic_cast<const HertzLaw *>(&contact.first_loading());
    if (law == nullptr)
      return {};
    const double m = impactor.mass;
    const double T = std::pow(m / (law->k * std::sqrt(impactor.velocity)), 0.4);
    return m / (impedance(section) * T);
  }



  double
  ZenerImpact::chosen_time_step(const double tolerance) const
  {
    const double pi = std::acos(-1.);
    // by powers of two from a time of the plate alone, the inverse frequency of
    // thickness shear, so that impactors share steps
    const double base =
      std::sqrt(section.rotary_inertia / section.mean_shear_stiffness());
    double step =
      base * std::exp2(std::floor(std::log2(contact_time() / 8. / base)));
    while (true)
      {
        step *= 0.5;
        // the largest step misses the peak of a half sine by up to half a step
        const double missed = 1. - std::cos(0.5 * pi * step / contact_time());
        const double changed =
          std::abs(peak_in_steps(step).force / peak.force - 1.);
        // the reference is good to about 1e-5
        if (std::max(missed, changed) <= std::max(tolerance, 1e-5))
          return step;
      }
  }
} // namespace PlateImpact
