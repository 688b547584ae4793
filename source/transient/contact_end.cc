#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/transient/plate_model.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// Steps in which the end of a contact is looked for.
    constexpr double most_steps_of_contact = 262144.;



    /// How long an impact may last.
    struct ContactTime
    {
      double shortest; ///< expected [s]
      double longest;  ///< that is waited for [s]
      bool   is_held;  ///< whether the plate throws the impactor back
    };

    ContactTime
    contact_time(const Parameters  &impact,
                 const ZenerImpact &expected,
                 const double       compliance)
    {
      const double of_zener   = 1.5 * expected.contact_time(),
                   half_space = 2. * expected.peak_on_rigid_plate().time;
      if (!std::isfinite(compliance)) // free to move, it is left sooner
        return {of_zener, 100. * half_space, false};
      const double mass       = expected.impactor.mass,
                   plate_mass = geometry_of(impact.plate).area *
        expected.section.mass_per_area,
                   half_period =
                     half_space + std::acos(-1.) * std::sqrt(mass * compliance);
      // heavier than the plate it bends that as a whole, for half a period
      return {mass > plate_mass ? std::max(of_zener, 1.1 * half_period) :
                                  of_zener,
              2. * half_period,
              true};
    }



    /// A little after the end of the impact, on the mesh by steps four times as
    /// long, or as long as anybody waits. [s]
    double
    end_by_steps(const LoadedPlate &plate,
                 const Parameters  &impact,
                 const ContactTime &wait)
    {
      const double dt = impact.time.time_step;
      // few digits are needed, but every step counts
      TimeParameters coarse = impact.time;
      coarse.time_step *= 4.;
      coarse.end_time = dt *
        std::ceil(std::min(most_steps_of_contact,
                           std::max(impact.time.end_time, wait.longest) / dt));
      TimeStepper stepper     = plate.steps_on_the_mesh(coarse);
      bool        is_touching = false;
      for (unsigned int step = 0; step < stepper.n_steps(); ++step)
        {
          stepper.advance();
          const ContactState &state = stepper.state();
          if (is_touching && state.force == 0. &&
              (!wait.is_held || state.impactor_velocity <= 0.))
            return dt * std::ceil(1.01 * state.time / dt);
          is_touching = is_touching || state.force > 0.;
        }
      return coarse.end_time;
    }
  } // namespace



  Parameters
  until_contact_ends(PlateModel       &plate,
                     const Parameters &impact,
                     const bool        needs_states)
  {
    if (impact.time.end_time > 0.)
      return impact;
    Parameters result         = impact;
    result.time.end_is_chosen = true;
    const double      dt      = impact.time.time_step;
    const ContactTime wait    = contact_time(impact,
                                          make_zener_impact(impact),
                                          plate.static_compliance(impact));
    // by powers of two, so that impactors share responses
    for (double n = std::exp2(std::ceil(std::log2(wait.shortest / dt)));;
         n *= 2.)
      {
        result.time.end_of_vectors = result.time.end_time = n * dt;
        const LoadedPlate loaded = plate.under(result, needs_states);
        if (loaded.is_stepped_on_the_mesh())
          {
            // more steps take more vectors
            result.time.integrator = IntegratorType::Newmark;
            result.time.end_time   = end_by_steps(loaded, result, wait);
            return result;
          }
        const std::optional<double> end =
          loaded.strike().history.end_of_impact(wait.is_held);
        if (end)
          result.time.end_time = dt * std::ceil(*end / dt);
        if (end || n >= most_steps_of_contact || n * dt >= wait.longest)
          return result;
      }
  }
} // namespace PlateImpact
