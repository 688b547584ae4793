#include "plate_impact/ritz_basis.h"

#include "plate_impact/exceptions.h"
#include "plate_impact/zener.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

namespace PlateImpact
{
  RitzBasis::RitzBasis(MeshPlate &plate, const double sigma)
    : plate(plate)
    , sigma(sigma)
  {}



  void
  RitzBasis::grow(const unsigned int n_wanted)
  {
    if (n_wanted <= n || complete)
      return;
    plate.factorize(sigma);
    if (n_wanted > Q.cols())
      {
        Q.conservativeResize(plate.load().size(), n_wanted);
        diagonal.conservativeResize(n_wanted);
        subdiagonal.conservativeResize(n_wanted);
      }
    while (n < n_wanted && !complete)
      append();
  }



  void
  RitzBasis::append()
  {
    // A times the candidate is what it is solved for
    if (n == 0)
      A_candidate = plate.load();
    else
      A_candidate = M_last;
    plate.solve(A_candidate, candidate);
    const double norm_before = norm_of_candidate();

    if (n > 0)
      {
        candidate -= diagonal[n - 1] * Q.col(n - 1);
        A_candidate -= diagonal[n - 1] * A_last;
      }
    if (n > 1)
      {
        candidate -= subdiagonal[n - 2] * Q.col(n - 2);
        A_candidate -= subdiagonal[n - 2] * A_before;
      }
    orthogonalize();

    const double norm = norm_of_candidate();
    if (norm <= 1e-10 * norm_before || n == Q.rows())
      {
        complete = true;
        return;
      }
    if (n == 0)
      load_norm = norm;
    else
      subdiagonal[n - 1] = norm;
    Q.col(n) = candidate / norm;
    A_before.swap(A_last);
    A_last = A_candidate / norm;
    plate.multiply_mass(Q.col(n), M_last);
    diagonal[n] = Q.col(n).dot(M_last);
    ++n;
  }



  void
  RitzBasis::orthogonalize()
  {
    if (n == 0)
      return;
    // orthogonal to the root of round-off serves as well as to round-off
    const double          tolerance = 1e-9 * norm_of_candidate();
    const Eigen::VectorXd overlap   = Q.leftCols(n).transpose() * A_candidate;
    const bool            has_lost  = overlap.cwiseAbs().maxCoeff() > tolerance;
    // the recurrence has two vectors to bring overlaps back from
    const bool repeats = has_lost && !is_second;
    if (has_lost || is_second)
      {
        candidate -= Q.leftCols(n) * overlap;
        plate.multiply_shifted(sigma, candidate, A_candidate);
      }
    is_second = repeats;
  }



  double
  RitzBasis::norm_of_candidate() const
  {
    const double square = candidate.dot(A_candidate);
    if (!std::isfinite(square))
      throw ComputationError("Ritz vector " + std::to_string(n + 1) +
                             " is not finite");
    return std::sqrt(std::max(0., square));
  }



  unsigned int
  RitzBasis::n_vectors() const
  {
    return n;
  }



  bool
  RitzBasis::is_complete() const
  {
    return complete;
  }



  double
  RitzBasis::shift() const
  {
    return sigma;
  }



  Eigen::Ref<const Eigen::MatrixXd>
  RitzBasis::vectors() const
  {
    return Q.leftCols(n);
  }



  Eigen::Ref<const Eigen::VectorXd>
  RitzBasis::mass_diagonal() const
  {
    return diagonal.head(n);
  }



  Eigen::Ref<const Eigen::VectorXd>
  RitzBasis::mass_subdiagonal() const
  {
    return subdiagonal.head(n - 1);
  }



  double
  RitzBasis::load() const
  {
    return load_norm;
  }



  namespace
  {
    /// y = A x for a symmetric tridiagonal matrix.
    void
    multiply_tridiagonal(const Eigen::VectorXd &diagonal,
                         const Eigen::VectorXd &beside,
                         const Eigen::VectorXd &x,
                         Eigen::VectorXd       &y)
    {
      const Eigen::Index n = beside.size();
      y                    = diagonal.cwiseProduct(x);
      y.head(n) += beside.cwiseProduct(x.tail(n));
      y.tail(n) += beside.cwiseProduct(x.head(n));
    }



    /// (K^-1)_11, from pivots that end at the first row; infinite unless all
    /// eigenvalues lie beyond what round-off leaves of the unit matrix.
    double
    first_of_inverse(const Eigen::VectorXd &diagonal,
                     const Eigen::VectorXd &beside)
    {
      const double round_off = 1e-13;
      double       pivot     = 0.;
      for (Eigen::Index i = diagonal.size() - 1; i >= 0; --i)
        {
          const double eliminated =
            i < beside.size() ? beside[i] * beside[i] / pivot : 0.;
          pivot = diagonal[i] - round_off - eliminated;
          if (pivot <= 0.)
            return std::numeric_limits<double>::infinity();
        }
      return 1. / pivot;
    }
  } // namespace



  RitzPlate::RitzPlate(const RitzBasis &basis, const unsigned int n)
    : basis(basis)
    , u(basis.load() * Eigen::VectorXd::Unit(n, 0))
    , mass(basis.mass_diagonal().head(n))
    , mass_beside(basis.mass_subdiagonal().head(n - 1))
    , stiffness(1. - basis.shift() * mass.array())
    , stiffness_beside(-basis.shift() * mass_beside)
    , compliance(1.001 * u[0] * u[0] *
                 first_of_inverse(stiffness, stiffness_beside))
    , inverse_pivots(n)
    , factor(n)
  {}



  const Eigen::VectorXd &
  RitzPlate::load() const
  {
    return u;
  }



  void
  RitzPlate::multiply_stiffness(const Eigen::VectorXd &x,
                                Eigen::VectorXd       &y) const
  {
    multiply_tridiagonal(stiffness, stiffness_beside, x, y);
  }



  void
  RitzPlate::factorize(const double c)
  {
    inverse_pivots[0] = 1. / (stiffness[0] + c * mass[0]);
    for (Eigen::Index i = 1; i < mass.size(); ++i)
      {
        const double beside = stiffness_beside[i - 1] + c * mass_beside[i - 1];
        factor[i]           = beside * inverse_pivots[i - 1];
        inverse_pivots[i] =
          1. / (stiffness[i] + c * mass[i] - factor[i] * beside);
      }
  }



  void
  RitzPlate::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    const Eigen::Index n = mass.size();
    x                    = b;
    for (Eigen::Index i = 1; i < n; ++i)
      x[i] -= factor[i] * x[i - 1];
    x.array() *= inverse_pivots.array();
    for (Eigen::Index i = n - 1; i > 0; --i)
      x[i - 1] -= factor[i] * x[i];
  }



  double
  RitzPlate::static_compliance() const
  {
    return compliance;
  }



  Eigen::Ref<const Eigen::MatrixXd>
  RitzPlate::vectors() const
  {
    return basis.vectors().leftCols(mass.size());
  }



  namespace
  {
    /// Growths by an eighth over which a force must settle: a quarter in all.
    constexpr std::size_t n_growths = 2;

    /// Share of the vectors added last in the displacements, in the norm of
    /// K + sigma M, below which fields are right: measured, eta is then that
    /// of the mesh to better than 1 % of itself.
    constexpr double field_tolerance = 1e-2;



    /// An impact on the plate in a basis.
    struct Trial
    {
      std::vector<double> forces; ///< after every step

      /// Sums over time of the squares of every coordinate.
      Eigen::VectorXd squares;

      Eigen::Index
      size() const
      {
        return squares.size();
      }

      /// Norm of the displacements in the vectors from `first`, relative to
      /// that in all.
      double
      share_beyond(const Eigen::Index first) const
      {
        const double all = squares.sum();
        return all > 0. ? std::sqrt(squares.tail(size() - first).sum() / all) :
                          0.;
      }
    };

    Trial
    try_impact(RitzPlate                &plate,
               const TimeParameters     &time,
               const ContactLaw         &law,
               const ContactIntegration &integration,
               const Impactor           &impactor)
    {
      TimeStepper        stepper(time, plate, law, integration, impactor);
      const unsigned int interval = std::max(1u, stepper.n_steps() / 100);
      Trial              result;
      result.forces.reserve(stepper.n_steps());
      result.squares.setZero(plate.load().size());
      for (unsigned int step = 1; step <= stepper.n_steps(); ++step)
        {
          stepper.advance();
          result.forces.push_back(stepper.state().force);
          if (step % interval == 0)
            result.squares += stepper.displacement().cwiseAbs2();
        }
      return result;
    }



    /// Root mean square over the contact of the difference of two histories,
    /// relative to the peak of the second.
    double
    relative_difference(const std::vector<double> &a,
                        const std::vector<double> &b)
    {
      double       sum = 0., peak = 0.;
      unsigned int n_contact = 0;
      for (std::size_t n = 0; n < b.size(); ++n)
        if (a[n] != 0. || b[n] != 0.)
          {
            sum += (a[n] - b[n]) * (a[n] - b[n]);
            peak = std::max(peak, b[n]);
            ++n_contact;
          }
      if (n_contact == 0)
        return 0.;
      return std::sqrt(sum / n_contact) / peak;
    }
  } // namespace



  namespace
  {
    double
    frequency(const int half_octave)
    {
      return std::exp2(0.5 * half_octave);
    }
  } // namespace



  RitzReduction::RitzReduction(MeshPlate            &plate,
                               const PlateSection   &section,
                               const TimeParameters &time,
                               const bool            needs_fields)
    : plate(plate)
    , section(section)
    , time(time)
    , needs_fields(needs_fields)
  {}



  RitzPlate *
  RitzReduction::settle(const ContactLaw         &law,
                        const ContactIntegration &integration,
                        const Impactor           &impactor)
  {
    // Vectors resolve frequencies around the root of sigma best. The force is
    // smooth enough for those beyond about a hundred over the contact time not
    // to matter; between 20 and 60 pi it makes no difference, so that the next
    // in a coarse sequence serves as well, and impactors share bases.
    const double contact_time = 2. * zener_peak(law, impactor, section).time;
    const int    half_octave =
      std::lround(2. * std::log2(30. * std::acos(-1.) / contact_time));

    // Waves run along the string of vectors at this speed: until the end time
    // fields take in three quarters of the distance, as measured, and a force
    // about as many as waves can come back from.
    const double distance = frequency(half_octave) * time.end_time;
    const double n_first =
      std::max(16., (needs_fields ? 0.4 : 0.25) * distance);
    // beyond half as many solves as steps the steps themselves are cheaper
    const double n_most = std::max(16., 0.5 * time.end_time / time.time_step);
    std::deque<Trial> trials; // the last ones
    for (double n = n_first; n <= n_most; n = 1.12 * n)
      {
        const unsigned int n_wanted = static_cast<unsigned int>(n);
        RitzPlate         &reduced  = reduced_plate(half_octave, n_wanted);
        if (reduced.load().size() < n_wanted)
          return &reduced; // there are no more
        try
          {
            trials.push_back(
              try_impact(reduced, time, law, integration, impactor));
          }
        catch (const ComputationError &)
          {
            // if it is not the reduction that fails, the mesh will tell
            return nullptr;
          }
        if (trials.size() <= n_growths)
          continue;
        // The force is a scalar product of displacements with the load, and
        // settles before they do.
        const Trial &earlier = trials.front(), &latest = trials.back();
        if (relative_difference(earlier.forces, latest.forces) <=
              time.ritz_tolerance &&
            (!needs_fields ||
             latest.share_beyond(trials[n_growths - 1].size()) <=
               field_tolerance))
          return &reduced;
        trials.pop_front();
      }
    return nullptr;
  }



  RitzPlate &
  RitzReduction::reduced_plate(const int half_octave, const unsigned int n)
  {
    const double omega = frequency(half_octave);
    RitzBasis   &basis =
      bases.try_emplace(half_octave, plate, omega * omega).first->second;
    basis.grow(n);
    return reduced_plates
      .try_emplace({half_octave, n}, basis, std::min(n, basis.n_vectors()))
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
