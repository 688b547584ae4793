#include "plate_impact/time_stepper.h"

#include "plate_impact/exceptions.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace PlateImpact
{
  namespace
  {
    /// The smallest number of steps, none longer than the scene's.
    unsigned int
    count_steps(const TimeParameters &time)
    {
      const double ratio = time.end_time / time.time_step;
      return static_cast<unsigned int>(
        std::max(1., std::ceil(ratio * (1 - 1e-9))));
    }



    void
    require_finite(const double       value,
                   const std::string &quantity,
                   const unsigned int step,
                   const double       time)
    {
      if (std::isfinite(value))
        return;
      std::ostringstream text;
      text << "step " << step << " (t = " << time << " s): the " << quantity
           << " is not finite (" << value << "); try a smaller Time/Time step";
      throw ComputationError(text.str());
    }
  } // namespace



  TimeStepper::TimeStepper(const TimeParameters     &time,
                           SemidiscretePlate        &plate,
                           const ContactLaw         &law,
                           const ContactIntegration &integration,
                           const Impactor           &impactor)
    : plate(plate)
    , law(law)
    , integration(integration)
    , beta(time.newmark_beta)
    , gamma(time.newmark_gamma)
    , steps(count_steps(time))
    , dt(time.end_time / steps)
    , c0(1. / (beta * dt * dt))
    , c1(1. / (beta * dt))
    , c2(1. / (2. * beta) - 1.)
    , impactor(impactor)
  {
    plate.factorize(c0);
    plate.solve(plate.load(), unit_response);
    n_solves          = 1;
    unit_displacement = plate.load().dot(unit_response);

    // at rest, without force
    z = v = Kz = Mv = Eigen::VectorXd::Zero(plate.load().size());
    if (gamma != 2. * beta)
      a = Ma = z;
    current.impactor_velocity = impactor.velocity;
    current.impactor_energy   = impactor.kinetic_energy();
  }



  void
  TimeStepper::advance()
  {
    ++step;
    const double known = integration.known_begin_force(current.force);

    // free displacement
    right_hand_side = c1 * Mv - (1. + c2) * Kz + (c2 * known) * plate.load();
    if (step > 1)
      {
        plate.solve(right_hand_side, increment);
        ++n_solves;
      }
    else
      increment.setZero(z.size()); // the plate is at rest

    const double phi = separated_at ? 0. : contact_force(known);
    if (phi != 0.)
      ++n_contacts;

    const double at_begin    = integration.acts_at_begin() ? 1. : 0.;
    const double load_factor = (1. + c2 * at_begin) * phi;
    if (load_factor != 0.)
      {
        right_hand_side += load_factor * plate.load();
        increment += load_factor * unit_response;
      }
    move_plate(phi);
    move_impactor(known + at_begin * phi, phi);
    update_state();
  }



  double
  TimeStepper::contact_force(const double known) const
  {
    const double plate_free =
      current.plate_displacement + plate.load().dot(increment);
    const double impactor_free = impactor.displacement +
      dt * impactor.velocity - dt * dt / impactor.mass * (0.5 - beta) * known;
    const double at_begin   = integration.acts_at_begin() ? 1. : 0.;
    const double compliance = (1. + c2 * at_begin) * unit_displacement +
      dt * dt / impactor.mass * (beta + (0.5 - beta) * at_begin);
    try
      {
        return solve_contact(integration,
                             law,
                             current.indentation,
                             impactor_free - plate_free,
                             compliance);
      }
    catch (const ComputationError &error)
      {
        throw ComputationError("step " + std::to_string(step) + ": " +
                               error.what());
      }
  }



  void
  TimeStepper::move_plate(const double end_force)
  {
    // velocities by eqs. 3 and 4 in terms of the increment
    const double from_increment = gamma / (beta * dt),
                 from_v         = 1. - gamma / beta,
                 from_a         = dt * (1. - gamma / (2. * beta));
    const bool has_a            = a.size() > 0;

    plate.multiply_stiffness(increment, K_increment);
    z += increment;
    Kz += K_increment;
    // M d = (K* d - K d) / c_0
    if (has_a)
      {
        const Eigen::VectorXd v_begin = v, Mv_begin = Mv;
        v  = from_increment * increment + from_v * v + from_a * a;
        Mv = from_increment / c0 * (right_hand_side - K_increment) +
          from_v * Mv + from_a * Ma;
        a  = c0 * increment - c1 * v_begin - c2 * a;
        Ma = end_force * plate.load() - Kz;
      }
    else
      {
        v = from_increment * increment + from_v * v;
        Mv =
          from_increment / c0 * (right_hand_side - K_increment) + from_v * Mv;
      }
  }



  void
  TimeStepper::move_impactor(const double begin_force, const double end_force)
  {
    impactor.displacement += dt * impactor.velocity -
      dt * dt / impactor.mass * ((0.5 - beta) * begin_force + beta * end_force);
    const double impulse =
      dt * ((1. - gamma) * begin_force + gamma * end_force);
    impactor.velocity -= impulse / impactor.mass;
    total_impulse += impulse;
  }



  void
  TimeStepper::update_state()
  {
    current.time = step == steps ? dt * steps : dt * step;
    current.plate_displacement += plate.load().dot(increment);
    current.impactor_displacement = impactor.displacement;
    current.impactor_velocity     = impactor.velocity;
    current.indentation =
      current.impactor_displacement - current.plate_displacement;
    current.force           = law.force(current.indentation);
    current.plate_energy    = 0.5 * (v.dot(Mv) + z.dot(Kz));
    current.contact_energy  = law.potential(current.indentation);
    current.impactor_energy = impactor.kinetic_energy();

    require_finite(current.plate_displacement,
                   "plate displacement",
                   step,
                   current.time);
    require_finite(current.total_energy(), "total energy", step, current.time);
    if (!separated_at && is_out_of_reach())
      separated_at = current.time;
  }



  bool
  TimeStepper::is_out_of_reach() const
  {
    // other parameters do not keep the energy that bounds the displacement
    if (beta != 0.25 || gamma != 0.5 || current.impactor_velocity > 0. ||
        current.impactor_displacement >= 0.)
      return false;
    // beyond round-off in the energy, however far the impactor has flown
    const double energy = (1. + 1e-6) * current.plate_energy;
    return -current.impactor_displacement >
      std::sqrt(2. * energy * plate.static_compliance());
  }



  std::optional<double>
  TimeStepper::separation_time() const
  {
    return separated_at;
  }



  unsigned int
  TimeStepper::n_steps() const
  {
    return steps;
  }



  const ContactState &
  TimeStepper::state() const
  {
    return current;
  }



  const Eigen::VectorXd &
  TimeStepper::displacement() const
  {
    return z;
  }



  double
  TimeStepper::impulse() const
  {
    return total_impulse;
  }



  unsigned int
  TimeStepper::n_linear_solves() const
  {
    return n_solves;
  }



  unsigned int
  TimeStepper::n_contact_steps() const
  {
    return n_contacts;
  }
} // namespace PlateImpact
