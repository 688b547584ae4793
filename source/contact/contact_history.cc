#include "plate_impact/contact/contact_history.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace PlateImpact
{
  const ContactState &
  ContactHistory::peak() const
  {
    return *std::max_element(history.begin(),
                             history.end(),
                             [](const ContactState &a, const ContactState &b) {
                               return a.force < b.force;
                             });
  }



  double
  ContactHistory::peak_of_curve() const
  {
    const std::size_t n = &peak() - history.data();
    if (n == 0 || n + 1 == history.size())
      return history[n].force;
    const double slope = 0.5 * (history[n + 1].force - history[n - 1].force),
                 curvature = history[n + 1].force - 2. * history[n].force +
      history[n - 1].force;
    return curvature < 0. ? history[n].force - 0.5 * slope * slope / curvature :
                            history[n].force;
  }



  bool
  ContactHistory::peak_is_on_ripples() const
  {
    const ContactState &top = peak();
    for (const ContactState *state = history.data(); state != &top; ++state)
      if (state[1].force < state->force)
        return true;
    return false;
  }



  double
  ContactHistory::difference_around(const double          time,
                                    const ContactHistory &other) const
  {
    const double        neighbourhood = 0.1;
    double              squares       = 0.;
    unsigned int        n_states      = 0;
    const ContactState *after         = other.history.data(),
                       *end           = after + other.history.size();
    for (const ContactState &state : history)
      {
        if (std::abs(state.time - time) > neighbourhood * time)
          continue;
        // against round-off of equal times
        while (after != end && after->time < state.time - 1e-9 * time)
          ++after;
        if (after == end)
          break;
        const double before     = after == other.history.data() ?
              0. :
              (after->time - state.time) / (after->time - after[-1].time),
                     difference = state.force - after->force +
          (before > 0. ? before * (after->force - after[-1].force) : 0.);
        squares += difference * difference;
        ++n_states;
      }
    return n_states > 0 ? std::sqrt(squares / n_states) : 0.;
  }



  std::optional<double>
  ContactHistory::end_of_impact(const bool is_held) const
  {
    for (std::size_t n = 1; n < history.size(); ++n)
      {
        const ContactState &before = history[n - 1], &after = history[n];
        const bool ends = before.overlap() > 0. && after.overlap() <= 0.;
        if (ends && (!is_held || after.impactor_velocity <= 0.))
          return before.time +
            (after.time - before.time) * before.overlap() /
            (before.overlap() - after.overlap());
      }
    return {};
  }



  void
  ContactHistory::write(std::ostream &out) const
  {
    const bool with_memory = history.back().dissipated_energy != 0.,
               is_damped   = history.back().plate_dissipated_energy != 0.;
    out.precision(17);
    out << "time,force,indentation,plate_displacement,impactor_displacement,"
           "impactor_velocity,plate_energy,contact_energy,impactor_energy"
        << (with_memory ? ",dissipated_energy,permanent_indentation" : "")
        << (is_damped ? ",plate_dissipated_energy\n" : "\n");
    for (const ContactState &s : history)
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
} // namespace PlateImpact
