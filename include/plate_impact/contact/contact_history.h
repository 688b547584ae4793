#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iosfwd>
#include <limits>
#include <optional>
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
  class ContactHistory
  {
  public:
    void
    add(const ContactState &state)
    {
      history.push_back(state);
    }

    const std::vector<ContactState> &
    states() const
    {
      return history;
    }

    /// The state of the largest force.
    const ContactState &
    peak() const;

    /// Largest force of the history as a curve: of the parabola through the
    /// peak and the states beside it. [N]
    double
    peak_of_curve() const;

    /// Whether the force falls on its way to the peak: other humps lead there.
    bool
    peak_is_on_ripples() const;

    /// Root of the mean square of the difference to the force of another
    /// history, interpolated, from 0.9 to 1.1 of a time; 0 where one of them
    /// does not reach it. [N]
    double
    difference_around(double time, const ContactHistory &other) const;

    /// From the last state without contact before the peak to it. [s]
    double
    rise_time() const
    {
      const ContactState *touch = &peak();
      while (touch != history.data() && touch->overlap() > 0.)
        --touch;
      return peak().time - touch->time;
    }

    /// By a linear interpolation of the indentation; empty when the contact
    /// lasts to the end of the history or when there is none. [s]
    std::optional<double>
    first_contact_end() const
    {
      return end_of_impact(/*is_held=*/false);
    }

    /// The same of the first contact after which the impactor moves away: waves
    /// may interrupt that of a heavy one. [s]
    /// @param is_held  whether the plate throws it back at last; if not, the
    ///                 impact ends with the first contact
    std::optional<double>
    end_of_impact(bool is_held) const;

    unsigned int
    n_contacts() const
    {
      unsigned int n_contacts = 0;
      for (std::size_t n = 1; n < history.size(); ++n)
        if (history[n].overlap() > 0. && history[n - 1].overlap() <= 0.)
          ++n_contacts;
      return n_contacts;
    }

    /// Largest displacement of the plate under the load until a time. [m]
    double
    max_plate_displacement(
      const double until = std::numeric_limits<double>::infinity()) const
    {
      double largest = 0.;
      for (const ContactState &state : history)
        if (state.time <= until)
          largest = std::max(largest, std::abs(state.plate_displacement));
      return largest;
    }

    /// Largest deviation of the total energy from its initial value, relative
    /// to that value.
    double
    relative_energy_drift() const
    {
      const double initial = history.front().total_energy();
      double       drift   = 0.;
      for (const ContactState &state : history)
        drift = std::max(drift, std::abs(state.total_energy() - initial));
      return drift / initial;
    }

    /// A table with the names above; the last three where energy is dissipated.
    void
    write(std::ostream &out) const;

    /// For the way from one process to another.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &history;
    }

  private:
    std::vector<ContactState> history;
  };
} // namespace PlateImpact
