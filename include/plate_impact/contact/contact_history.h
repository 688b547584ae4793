#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <vector>

namespace PlateImpact
{
  /// The striking body as a point mass; towards the plate is positive. (The
  /// paper prints its displacement as the double integral of f/m; meant is v0 t
  /// minus that.)
  struct Impactor
  {
    double mass;         ///< [kg]
    double displacement; ///< since first touch [m]
    double velocity;     ///< [m/s]

    double
    kinetic_energy() const
    {
      return 0.5 * mass * velocity * velocity;
    }
  };

  /// State of the impact at one time. Displacements are positive towards the
  /// plate; the plate's is the load-weighted one that enters the contact law.
  struct ContactState
  {
    double time                    = 0.; ///< [s]
    double force                   = 0.; ///< [N]
    double indentation             = 0.; ///< [m]
    double plate_displacement      = 0.; ///< [m]
    double impactor_displacement   = 0.; ///< [m]
    double impactor_velocity       = 0.; ///< [m/s]
    double plate_energy            = 0.; ///< [J]
    double contact_energy          = 0.; ///< [J]
    double impactor_energy         = 0.; ///< [J]
    double dissipated_energy       = 0.; ///< by a contact with memory [J]
    double permanent_indentation   = 0.; ///< that such a one has left [m]
    double plate_dissipated_energy = 0.; ///< by the plate's damping [J]

    double
    total_energy() const
    {
      return plate_energy + contact_energy + impactor_energy +
        dissipated_energy + plate_dissipated_energy;
    }

    /// Of the bodies that touch, below 0 of those that do not. [m]
    double
    overlap() const
    {
      return indentation - permanent_indentation;
    }
  };

  /// The states of a transient at t = 0 and after every step, in order, and
  /// what an engineer reads from them. Forces are zero between contacts.
  struct ContactHistory
  {
    std::vector<ContactState> states;

    /// The state of the largest force.
    const ContactState &
    peak() const
    {
      return *std::max_element(states.begin(), states.end(), by_force);
    }

    /// Largest force of the history as a curve: of the parabola through the
    /// peak and the states beside it. [N]
    double
    peak_of_curve() const
    {
      const std::size_t n = &peak() - states.data();
      if (n == 0 || n + 1 == states.size())
        return states[n].force;
      const double before = states[n - 1].force, force = states[n].force,
                   after = states[n + 1].force, slope = 0.5 * (after - before),
                   curvature = after - 2. * force + before;
      return curvature < 0. ? force - 0.5 * slope * slope / curvature : force;
    }

    /// Whether the force falls on its way to the peak: other humps lead there.
    bool
    peak_is_on_ripples() const
    {
      return !std::is_sorted(states.data(), &peak() + 1, by_force);
    }

    /// Root of the mean square of the difference to the force of another
    /// history, interpolated, from 0.9 to 1.1 of a time; 0 where one of them
    /// does not reach it. [N]
    double
    difference_around(const double time, const ContactHistory &other) const
    {
      const double        neighbourhood = 0.1;
      double              squares       = 0.;
      unsigned int        n_states      = 0;
      const ContactState *after         = other.states.data(),
                         *end           = after + other.states.size();
      for (const ContactState &state : states)
        {
          if (std::abs(state.time - time) > neighbourhood * time)
            continue;
          // against round-off of equal times
          while (after != end && after->time < state.time - 1e-9 * time)
            ++after;
          if (after == end)
            break;
          const double before     = after == other.states.data() ?
                0. :
                (after->time - state.time) / (after->time - after[-1].time),
                       difference = state.force - after->force +
            (before > 0. ? before * (after->force - after[-1].force) : 0.);
          squares += difference * difference;
          ++n_states;
        }
      return n_states > 0 ? std::sqrt(squares / n_states) : 0.;
    }

    /// From the last state without contact before the peak to it. [s]
    double
    rise_time() const
    {
      const ContactState *touch = &peak();
      while (touch != states.data() && touch->overlap() > 0.)
        --touch;
      return peak().time - touch->time;
    }

    /// End of the first contact, by a linear interpolation of the indentation;
    /// empty when it lasts to the end of the history or when there is none. [s]
    /// @param is_held  whether the plate throws the impactor back at last: then
    ///                 of the first contact after which it moves away, since
    ///                 waves may interrupt that of a heavy one
    std::optional<double>
    end_of_impact(const bool is_held = false) const
    {
      for (std::size_t n = 1; n < states.size(); ++n)
        {
          const ContactState &before = states[n - 1], &after = states[n];
          const bool ends = before.overlap() > 0. && after.overlap() <= 0.;
          if (ends && (!is_held || after.impactor_velocity <= 0.))
            return before.time +
              (after.time - before.time) * before.overlap() /
              (before.overlap() - after.overlap());
        }
      return {};
    }

    /// That of a plate that throws the impactor back or, where it does not, of
    /// the first contact. [s]
    std::optional<double>
    last_end_of_impact() const
    {
      const auto end = end_of_impact(/*is_held=*/true);
      return end ? end : end_of_impact();
    }

    unsigned int
    n_contacts() const
    {
      unsigned int n_contacts = 0;
      for (std::size_t n = 1; n < states.size(); ++n)
        if (states[n].overlap() > 0. && states[n - 1].overlap() <= 0.)
          ++n_contacts;
      return n_contacts;
    }

    /// Largest displacement of the plate under the load until a time. [m]
    double
    max_plate_displacement(
      const double until = std::numeric_limits<double>::infinity()) const
    {
      double largest = 0.;
      for (const ContactState &state : states)
        if (state.time <= until)
          largest = std::max(largest, std::abs(state.plate_displacement));
      return largest;
    }

    /// Largest deviation of the total energy from its initial value, relative
    /// to that value.
    double
    relative_energy_drift() const
    {
      const double initial = states.front().total_energy();
      double       drift   = 0.;
      for (const ContactState &state : states)
        drift = std::max(drift, std::abs(state.total_energy() - initial));
      return drift / initial;
    }

    /// A table with the names above; the last three where energy is dissipated.
    void
    write(std::ostream &out) const
    {
      const bool with_memory = states.back().dissipated_energy != 0.,
                 is_damped   = states.back().plate_dissipated_energy != 0.;
      out.precision(17);
      out << "time,force,indentation,plate_displacement,impactor_displacement,"
             "impactor_velocity,plate_energy,contact_energy,impactor_energy"
          << (with_memory ? ",dissipated_energy,permanent_indentation" : "")
          << (is_damped ? ",plate_dissipated_energy\n" : "\n");
      for (const ContactState &s : states)
        {
          out << s.time << ',' << s.force << ',' << s.indentation << ','
              << s.plate_displacement << ',' << s.impactor_displacement << ','
              << s.impactor_velocity << ',' << s.plate_energy << ','
              << s.contact_energy << ',' << s.impactor_energy;
          if (with_memory)
            out << ',' << s.dissipated_energy << ',' << s.permanent_indentation;
          if (is_damped)
            out << ',' << s.plate_dissipated_energy;
          out << '\n';
        }
    }

    /// For the way from one process to another.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &states;
    }

  private:
    static bool
    by_force(const ContactState &a, const ContactState &b)
    {
      return a.force < b.force;
    }
  };
} // namespace PlateImpact
