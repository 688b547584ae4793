#include "plate_impact/transient/ritz_reduction.h"

#include "plate_impact/base/entries.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/contact/make_contact.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace PlateImpact
{
  namespace
  {
    /// Returns of the waves from the nearest edge after which a plate rings,
    /// and no longer time takes more vectors.
    constexpr double returns_until_it_rings = 8.;



    /// Estimated error of the last of three histories, a root of the mean
    /// square over the steps in which two of them are not zero and have a
    /// value. Errors of different bases are uncorrelated ringing: differences
    /// are |a - b|^2 = e_a^2 + e_b^2, and three of them tell the error of each.
    /// An estimate below what two equal errors would differ by is not trusted.
    double
    estimated_error(const std::deque<Eigen::ArrayX2d> &three,
                    const unsigned int                 column)
    {
      const auto squared_difference = [&](const unsigned int i,
                                          const unsigned int j) {
        const Eigen::ArrayXd a = three[i].col(column), b = three[j].col(column),
                             difference = a - b;
        const double n                  = ((a != 0.) || (b != 0.)).count();
        return difference.isFinite().select(difference.square(), 0.).sum() /
          std::max(1., n);
      };
      const double of_last = squared_difference(1, 2),
                   others = squared_difference(0, 2) - squared_difference(0, 1);
      return std::sqrt(0.5 * std::max(of_last, of_last + others));
    }



    /// What a number of vectors is judged by, relative to the peak force: the
    /// force, and without contact, for another impactor may be in contact then,
    /// the displacement times the stiffness of the contact at the peak. NaN
    /// with contact; zero without a peak.
    Eigen::ArrayX2d
    judged(const ContactHistory &history, const Contact &contact)
    {
      const ContactState &peak = history.peak();
      Eigen::ArrayX2d result = Eigen::ArrayX2d::Zero(history.states.size(), 2);
      if (peak.force <= 0.)
        return result;
      // on the curve of first loading
      const double per_displacement =
        contact.stiffness(peak.indentation) / peak.force;
      for (std::size_t n = 0; n < history.states.size(); ++n)
        {
          const ContactState &state = history.states[n];
          result(n, 0)              = state.force / peak.force;
          result(n, 1)              = state.force > 0. ?
                         std::numeric_limits<double>::quiet_NaN() :
                         per_displacement * state.plate_displacement;
        }
      return result;
    }



    /// Whether coordinates from the first on hold less than 1e-3 of the
    /// displacements, in the norm of K + sigma M over all times: then eta was
    /// that of the mesh within 1 %.
    bool
    is_little_beyond(const unsigned int first, TimeStepper stepper)
    {
      const unsigned int interval = std::max(1u, stepper.scheme.n_steps / 100);
      const Eigen::Index n_beyond = stepper.displacement().size() - first;
      double             beyond = 0., all = 0.;
      for (unsigned int n = interval; n <= stepper.scheme.n_steps;
           n += interval)
        {
          stepper.advance(interval);
          beyond += stepper.displacement().tail(n_beyond).squaredNorm();
          all += stepper.displacement().squaredNorm();
        }
      return beyond <= 1e-6 * all;
    }



    /// Longer steps where there are very many, but enough for a contact of the
    /// infinite plate: the step hardly matters. Schemes that damp would damp
    /// more in these, and keep theirs.
    NewmarkScheme
    scheme_to_judge(const NewmarkScheme &scheme,
                    TimeParameters       time,
                    const double         contact_time)
    {
      const double most_steps = 2000., fewest_steps_of_contact = 64.;
      if (scheme.conserves_energy)
        time.time_step *=
          std::max(1.,
                   std::floor(std::min(
                     scheme.n_steps / most_steps,
                     contact_time / (fewest_steps_of_contact * scheme.dt))));
      return {time, scheme.integration};
    }



    /// Twice the logarithm to base 2 of the root of the shift [1/s].
    int
    half_octave(const double contact_time, const double end_time)
    {
      // The smaller the shift, the fewer vectors it takes for waves to run
      // along them until the end time; but below this one the terminator shows
      // in the force. Measured for 0.5 to 21 contact times; rounded, so that
      // impactors share bases.
      const double duration = std::pow(std::min(end_time, contact_time), 0.6) *
        std::pow(end_time, 0.4);
      return std::lround(2. * std::log2(12. * std::acos(-1.) / duration));
    }



    /// Whether it is known beforehand that stepping on the mesh takes fewer
    /// solves than vectors would.
    bool
    steps_are_fewer(const Parameters &scene, const double n_unknowns)
    {
      // Until waves come back from an edge, the terminator stands for the
      // plate. After that a wave of frequency omega which is followed for T
      // takes T (sigma + omega^2) / (2 sigma^{1/2}) vectors, T omega at the
      // best sigma, and the waves of a contact reach up to some 5 pi /
      // contact_time, where the mesh carries them: coarse ones have fewer
      // vectors. Zener's contact is that of a point.
      const TimeParameters &time = scene.time;
      if (n_unknowns < 3. * time.end_time / time.time_step)
        return false;
      const ZenerImpact expected = make_zener_impact(scene);
      if (!expected.loss_factor())
        return false;
      const double back =
        expected.return_of_waves(geometry_of(scene.plate).distance_to_edge);
      return time.end_time > back &&
        time.end_time < returns_until_it_rings * back &&
        expected.contact_time() < 16. * time.time_step;
    }



    /// An impactor whose numbers are round in units of the plate, lighter,
    /// stiffer and faster: its contact is shorter, which takes more vectors.
    ImpactorParameters
    nearby(ImpactorParameters impactor, const PlateParameters &plate)
    {
      // to the power of two above, in a unit
      const auto round_up = [](const double value, const double unit) {
        return unit * std::exp2(std::ceil(std::log2(value / unit)));
      };
      const double h = plate.thickness, density = plate.density,
                   E    = PlateSection(plate).contact_modulus,
                   mass = density * h * h * h;
      impactor.mass     = mass *
        std::exp2(std::floor(std::log2(make_impactor(impactor).mass / mass)));
      impactor.density        = 0.; // what counts is the mass
      impactor.contact_radius = 0.; // it has one of its own
      impactor.radius         = round_up(impactor.radius, h);
      impactor.youngs_modulus = round_up(impactor.youngs_modulus, E);
      impactor.velocity = round_up(impactor.velocity, std::sqrt(E / density));
      return impactor;
    }



    const std::vector<Word<IntegratorType>> integrators = {
      {IntegratorType::Newmark, "Newmark"},
      {IntegratorType::Ritz_vectors, "Ritz vectors"}};
  } // namespace



  SemidiscreteSystem &
  RitzReduction::system_for(const Parameters &parameters)
  {
    if (time.integrator == IntegratorType::Newmark || !mesh->system.is_linear)
      return mesh->system;
    Parameters rounded          = parameters;
    rounded.time                = time;
    rounded.impactor            = nearby(parameters.impactor, parameters.plate);
    const auto           key    = std::make_tuple(rounded.contact,
                                     rounded.impactor,
                                     rounded.plate.yield_strength);
    SemidiscreteSystem *&system = settled[key];
    if (system == nullptr)
      system = settle(rounded);
    return *system;
  }



  SemidiscreteSystem *
  RitzReduction::settle(const Parameters &rounded)
  {
    const double n_unknowns = mesh->system.load.size();
    if (steps_are_fewer(rounded, n_unknowns))
      return &mesh->system;
    const Contact     contact  = make_contact(rounded);
    const Impactor    impactor = make_impactor(rounded.impactor);
    const ZenerImpact expected(contact, impactor, PlateSection(rounded.plate));
    // a plate that rings has the same vectors until any later time
    const double followed =
      std::min(time.end_time,
               returns_until_it_rings *
                 expected.return_of_waves(
                   geometry_of(rounded.plate).distance_to_edge));
    const int octave = half_octave(expected.contact_time(), followed);
    // Waves run along the vectors at this speed, and should not be back from
    // their end. The third basis is the first that is judged.
    const double n_first =
                   std::max(12., 0.24 * std::exp2(0.5 * octave) * followed),
                 growth = 1.15;
    // Once the vectors have cost as much as the steps would, or fill 1.6 GB of
    // memory, the steps are made after all: n vectors cost n + n^2 / 2400
    // solves, as measured on 12,000 to 120,000 unknowns with 125 to 940
    // vectors.
    const double n_steps = time.end_time / time.time_step;
    const double n_most =
      std::min(std::max(16., 1200. * (std::sqrt(1. + n_steps / 600.) - 1.)),
               2e8 / n_unknowns);
    if (n_most < std::min(n_first * growth * growth, n_unknowns))
      return &mesh->system;
    const NewmarkScheme judging =
      scheme_to_judge(scheme, time, expected.contact_time());
    std::deque<Eigen::ArrayX2d> last_three;
    unsigned int                n_before = 0;
    for (double n = n_first; n_before < static_cast<unsigned int>(n_most);
         n *= growth)
      {
        const auto n_wanted    = static_cast<unsigned int>(std::min(n, n_most));
        ReducedSystem &reduced = reduced_system(octave, n_wanted);
        if (reduced.n_vectors < n_wanted)
          return &reduced; // there are no more
        try
          {
            last_three.push_back(judged(
              impact(judging, reduced, contact, impactor, judging.n_steps)
                .history,
              contact));
            // The force is a scalar product of displacements with the load,
            // and settles before they do.
            if (last_three.size() == 3 &&
                estimated_error(last_three, 0) <= time.ritz_tolerance &&
                estimated_error(last_three, 1) <= time.ritz_tolerance &&
                (!needs_fields ||
                 is_little_beyond(n_before,
                                  {judging, reduced, contact, impactor})))
              return &reduced;
          }
        catch (const ComputationError &)
          {
            // if it is not the reduction that fails, the mesh will tell
            return &mesh->system;
          }
        if (last_three.size() == 3)
          last_three.pop_front();
        n_before = n_wanted;
      }
    return &mesh->system;
  }



  ReducedSystem &
  RitzReduction::reduced_system(const int half_octave, const unsigned int n)
  {
    const double omega = std::exp2(0.5 * half_octave);
    RitzBasis   &basis =
      mesh->bases.try_emplace(half_octave, mesh->system, omega * omega)
        .first->second;
    basis.grow(n);
    const unsigned int n_used = std::min(n, basis.n_vectors());
    const bool holds_all = basis.is_complete() && n_used == basis.n_vectors();
    // a longer terminator changes little
    const unsigned int n_terminator =
      holds_all ? 0. : std::min(500., 7. * omega * time.end_time);
    return reduced_systems
      .try_emplace({half_octave, n}, basis, n_used, n_terminator)
      .first->second;
  }



  Impact
  RitzReduction::impact(const NewmarkScheme &by,
                        SemidiscreteSystem  &system,
                        const Contact       &contact,
                        const Impactor      &impactor,
                        const unsigned int   n_steps)
  {
    std::unique_ptr<PlateMotion> motion;
    // The work of the force is the plate's energy where nothing dissipates it.
    // A step by the response multiplies all forces before it; one in vectors
    // takes as long as 40 products per vector.
    if (by.conserves_energy && system.damping == 0. && system.is_linear &&
        (&system == &mesh->system || by.n_steps < 40 * system.load.size()))
      motion = std::make_unique<PlateResponse>(
        responses.try_emplace({&system, by.n_steps}, by, system).first->second);
    TimeStepper stepper(by, system, contact, impactor, std::move(motion));
    stepper.advance(n_steps);
    return stepper.impact();
  }



  void
  TimeParameters::declare_entries(Entries &entries)
  {
    const auto entry = entries.section("Time");
    entry("End time", "80e-6", number_from(0), end_time)
      .means(
        "0: to the end of the first contact after which the impactor moves "
        "away from the plate. [s]");
    entry("Time step", "1e-7", number_from(0), time_step)
      .means("Shortened if End time is not a multiple of it. 0: the program "
             "halves the step until Zener's equation meets Step tolerance. "
             "[s]");
    entry("Step tolerance", "1e-4", number_between(0, 1), step_tolerance)
      .means("Relative error of the peak force that a time step chosen by the "
             "program may cause. [-]");
    entry("Integrator", "Ritz vectors", one_of(integrators), integrator)
      .means("What Newmark's method integrates. Newmark: the unknowns of the "
             "mesh. Ritz vectors: the coordinates of load-dependent Ritz "
             "vectors, as many as the force needs; the unknowns of the mesh "
             "after all if it needs more vectors than there are steps.");
    entry("Ritz tolerance", "1e-5", number_above(0), ritz_tolerance)
      .means("Ritz vectors are added until the estimated error that they cause "
             "in the force, a root mean square over the contact, is below this "
             "fraction of the peak force. [-]");
    entry("Newmark beta", "0.25", number_up_to(0, 1), newmark_beta)
      .means("At least half of gamma: unconditionally stable. [-]");
    entry("Newmark gamma", "0.5", number_from(0.5), newmark_gamma)
      .means("Above 0.5 the scheme damps, to first order. [-]");
  }
} // namespace PlateImpact
