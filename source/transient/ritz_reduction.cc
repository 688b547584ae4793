#include "plate_impact/transient/ritz_reduction.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/contact/make_contact_law.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/transient/time_stepper.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    /// Share of what lies beyond the basis before in the displacements, in the
    /// norm of K + sigma M, below which fields are right: measured, eta is then
    /// that of the mesh to better than 1 % of itself.
    constexpr double field_tolerance = 1e-3;



    /// Numbers in the vectors: 1.6 GB.
    constexpr double most_numbers = 2e8;



    /// Vectors that cost as much as a number of steps: a solve each, which is
    /// as much as making one orthogonal to 50 others (measured on 1000 to 30000
    /// unknowns), n + n^2 / 100 solves.
    double
    vectors_worth(const double n_steps)
    {
      return std::max(16., 50. * (std::sqrt(1. + 0.04 * n_steps) - 1.));
    }



    /// Mean square of the difference of two histories over the steps in which
    /// they are not zero; none where one has no value.
    double
    squared_difference(const std::vector<double> &a,
                       const std::vector<double> &b)
    {
      double       sum      = 0.;
      unsigned int n_counts = 0;
      for (std::size_t n = 0; n < b.size(); ++n)
        if (a[n] != 0. || b[n] != 0.)
          {
            const double difference = a[n] - b[n];
            if (std::isfinite(difference))
              sum += difference * difference;
            ++n_counts;
          }
      return n_counts > 0 ? sum / n_counts : 0.;
    }



    /// Estimated error of the last history of three, the root of its mean
    /// square. Once waves no longer come
    /// back from the end of the chain of vectors, the errors of different
    /// bases are uncorrelated ringing: differences are |a - b|^2 = e_a^2 +
    /// e_b^2, and three of them tell the error of each. An estimate below what
    /// two equal errors would differ by is not trusted.
    double
    estimated_error(const std::vector<double> &first,
                    const std::vector<double> &second,
                    const std::vector<double> &third)
    {
      const double of_last = squared_difference(second, third);
      return std::sqrt(std::max(0.5 * of_last,
                                0.5 *
                                  (squared_difference(first, third) + of_last -
                                   squared_difference(first, second))));
    }



    double
    frequency(const int half_octave)
    {
      return std::exp2(0.5 * half_octave);
    }



    /// The power of two above or below.
    double
    round_up(const double value, const double unit)
    {
      return unit * std::exp2(std::ceil(std::log2(value / unit)));
    }

    double
    round_down(const double value, const double unit)
    {
      return unit * std::exp2(std::floor(std::log2(value / unit)));
    }



    /// An impactor whose numbers are round in units of the plate, lighter,
    /// stiffer and faster: its contact is shorter, which takes more vectors.
    ImpactorParameters
    nearby(ImpactorParameters     impactor,
           const PlateParameters &plate,
           const PlateSection    &section)
    {
      const double h = plate.thickness, E = section.contact_modulus,
                   density = plate.density;
      impactor.mass =
        round_down(make_impactor(impactor).mass, density * h * h * h);
      impactor.density        = 0.; // what counts is the mass
      impactor.radius         = round_up(impactor.radius, h);
      impactor.youngs_modulus = round_up(impactor.youngs_modulus, E);
      impactor.velocity = round_up(impactor.velocity, std::sqrt(E / density));
      return impactor;
    }
  } // namespace



  RitzReduction::RitzReduction(FullSystem               &full,
                               const PlateParameters    &plate,
                               const TimeParameters     &time,
                               const ContactIntegration &integration,
                               const bool                needs_fields)
    : Integrator(time, integration)
    , full(full)
    , plate(plate)
    , section(plate)
    , needs_fields(needs_fields)
  {}



  RitzReduction::Histories
  RitzReduction::histories(ReducedSystem    &reduced,
                           const ContactLaw &law,
                           const Impactor   &impactor)
  {
    const NewmarkScheme scheme(time);
    const auto          impact = [&] {
      if (scheme.conserves_energy())
        return response(reduced).impact(law, impactor, scheme.n_steps);
      TimeStepper stepper(time, reduced, law, integration, impactor);
      return step_to_end(stepper);
    };
    const ContactHistory history = impact().history;
    const ContactState  &peak    = history.peak();
    Histories            result;
    if (peak.force <= 0.)
      return result;
    const double none = std::numeric_limits<double>::quiet_NaN();
    // on the curve of first loading
    const double per_displacement =
      law.stiffness(peak.indentation) / peak.force;
    for (const ContactState &state : history.states())
      {
        const bool touches = state.force > 0.;
        result.force.push_back(state.force / peak.force);
        result.displacement.push_back(
          touches ? none : per_displacement * state.plate_displacement);
      }
    return result;
  }



  double
  RitzReduction::share_beyond(const unsigned int first,
                              ReducedSystem     &reduced,
                              const ContactLaw  &law,
                              const Impactor    &impactor) const
  {
    TimeStepper        stepper(time, reduced, law, integration, impactor);
    const unsigned int interval = std::max(1u, stepper.n_steps() / 100);
    const Eigen::Index n_beyond = reduced.load().size() - first;
    double             beyond = 0., all = 0.;
    for (unsigned int step = 1; step <= stepper.n_steps(); ++step)
      {
        stepper.advance();
        if (step % interval != 0)
          continue;
        beyond += stepper.displacement().tail(n_beyond).squaredNorm();
        all += stepper.displacement().squaredNorm();
      }
    return all > 0. ? std::sqrt(beyond / all) : 0.;
  }



  SemidiscreteSystem &
  RitzReduction::system_for(const Parameters &parameters)
  {
    Parameters                rounded  = parameters;
    const ImpactorParameters &impactor = rounded.impactor =
      nearby(parameters.impactor, plate, section);
    const auto key   = std::make_pair(parameters.contact, impactor);
    auto       known = settled.find(key);
    if (known == settled.end())
      {
        const auto     law     = make_contact_law(rounded);
        const Impactor struck  = make_impactor(impactor);
        ReducedSystem *reduced = nullptr;
        if (!steps_are_fewer(*make_half_space_law(rounded), struck))
          reduced = settle(*law, struck);
        known = settled.emplace(key, reduced).first;
      }
    if (known->second == nullptr)
      return full;
    return *known->second;
  }



  bool
  RitzReduction::steps_are_fewer(const ContactLaw &law,
                                 const Impactor   &impactor) const
  {
    // Until waves come back from an edge, the terminator stands for the
    // plate. After that a wave of frequency omega which
    // is followed for T takes T (sigma + omega^2) / (2 sigma^{1/2}) vectors,
    // T omega at the best sigma, and the waves of a contact reach up to some
    // 5 pi / contact_time, where the mesh carries them: coarse ones have fewer
    // vectors. Zener's contact is that of a point.
    if (law.hertz_coefficient() == std::nullopt ||
        full.load().size() < 3. * time.end_time / time.time_step)
      return false;
    const double contact_time = 2. * zener_peak(law, impactor, section).time;
    const double echo         = 2. * geometry_of(plate)->distance_to_edge() /
      contact_wave(section, contact_time).group_speed;
    return time.end_time > echo && contact_time < 16. * time.time_step;
  }



  int
  RitzReduction::half_octave(const ContactLaw &law,
                             const Impactor   &impactor) const
  {
    // The fewer vectors the smaller sigma is, for waves to run along them until
    // the end time T; but below this number what is joined to their end shows
    // in the force. Measured for 0.5 to 21 contact times, and rounded, so that
    // impactors share bases.
    const double contact_time =
      std::min(time.end_time, 2. * zener_peak(law, impactor, section).time);
    const double duration =
      std::pow(contact_time, 0.6) * std::pow(time.end_time, 0.4);
    return std::lround(2. * std::log2(12. * std::acos(-1.) / duration));
  }



  ReducedSystem *
  RitzReduction::settle(const ContactLaw &law, const Impactor &impactor)
  {
    // Waves run along the vectors at this speed; a force is right when those
    // that the end reflects cannot be back before the end time. Fields may
    // follow with the third basis, the first that is judged.
    const int    octave   = half_octave(law, impactor);
    const double distance = frequency(octave) * time.end_time;
    const double n_first = std::max(12., 0.24 * distance), growth = 1.15;
    // once the vectors have cost as much as the steps would, or fill the
    // memory, the steps are made after all
    const double n_most =
      std::min(vectors_worth(time.end_time / time.time_step),
               most_numbers / full.load().size());
    const double n_unknowns = full.load().size();
    if (n_most < std::min(n_first * growth * growth, n_unknowns))
      return nullptr;
    std::deque<Histories> last_three;
    unsigned int          n_before = 0;
    for (double n = n_first; n <= n_most; n *= growth)
      {
        const unsigned int n_wanted = static_cast<unsigned int>(n);
        ReducedSystem     &reduced  = reduced_system(octave, n_wanted);
        if (reduced.n_vectors() < n_wanted)
          return &reduced; // there are no more
        try
          {
            last_three.push_back(histories(reduced, law, impactor));
            const auto is_settled =
              [&](const std::vector<double> Histories::*of) {
                return estimated_error(last_three[0].*of,
                                       last_three[1].*of,
                                       last_three[2].*of) <=
                  time.ritz_tolerance;
              };
            // The force is a scalar product of displacements with the load,
            // and settles before they do.
            if (last_three.size() == 3 && is_settled(&Histories::force) &&
                is_settled(&Histories::displacement) &&
                (!needs_fields ||
                 share_beyond(n_before, reduced, law, impactor) <=
                   field_tolerance))
              return &reduced;
          }
        catch (const ComputationError &)
          {
            // if it is not the reduction that fails, the mesh will tell
            return nullptr;
          }
        if (last_three.size() == 3)
          last_three.pop_front();
        n_before = n_wanted;
      }
    return nullptr;
  }



  ReducedSystem &
  RitzReduction::reduced_system(const int half_octave, const unsigned int n)
  {
    const double omega = frequency(half_octave);
    RitzBasis   &basis =
      bases.try_emplace(half_octave, full, omega * omega).first->second;
    basis.grow(n);
    // a longer terminator changes little
    const unsigned int n_terminator =
      std::min(500., 7. * omega * time.end_time);
    return reduced_systems
      .try_emplace({half_octave, n},
                   basis,
                   std::min(n, basis.n_vectors()),
                   n_terminator)
      .first->second;
  }



  unsigned int
  RitzReduction::n_vectors() const
  {
    unsigned int n = 0;
    for (const auto &[half_octave, basis] : bases)
      n += basis.n_vectors();
    return n;
  }
} // namespace PlateImpact
