#include "plate_impact/transient/ritz_basis.h"

#include "plate_impact/base/exceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace PlateImpact
{
  namespace
  {
    /// Vectors coupled to those before by less than this, in the units of
    /// K + sigma M, move with 1e-4 of them at 30 times the frequency of the
    /// shift, where nothing is left of a contact force.
    constexpr double least_coupling = 1e-7;

    /// Share of vectors before in a candidate, in exact arithmetic 0, from
    /// which what is left of it is round-off as well.
    constexpr double most_overlap = 0.1;

    /// The root of round-off serves as well as round-off.
    constexpr double allowed_overlap = 1e-9;

    /// Vectors after which all before are looked at, whatever is expected.
    constexpr unsigned int most_without_look = 30;



    /// What elimination from the first row on leaves of the diagonal.
    Eigen::VectorXd
    pivots(const TridiagonalMatrix &A)
    {
      Eigen::VectorXd result = A.diagonal;
      for (Eigen::Index i = 0; i < A.beside.size(); ++i)
        result[i + 1] -= A.beside[i] * A.beside[i] / result[i];
      return result;
    }



    /// T of the first n vectors, continued by the terminator.
    TridiagonalMatrix
    continued_mass(const RitzBasis   &basis,
                   const unsigned int n,
                   const unsigned int n_terminator)
    {
      const TridiagonalMatrix T       = basis.mass(n);
      const double            uniform = 0.25 / basis.sigma;
      TridiagonalMatrix       result  = {
               Eigen::VectorXd::Constant(n + n_terminator, 2. * uniform),
               Eigen::VectorXd::Constant(n + n_terminator - 1, uniform)};
      result.diagonal.head(n)   = T.diagonal;
      result.beside.head(n - 1) = T.beside;
      if (n_terminator > 0)
        {
          // Elimination leaves pivots above `uniform` all along the
          // terminator, in T as in K, if the first is at least that: the
          // coupling leaves 2 uniform - coupling^2 / pivot.
          const TridiagonalMatrix K = {1. / basis.sigma - T.diagonal.array(),
                                       T.beside};
          const double pivot   = std::min(pivots(T)[n - 1], pivots(K)[n - 1]);
          result.beside[n - 1] = std::sqrt(uniform * std::max(0., pivot));
        }
      return result;
    }



    /// (K^-1)_11, from pivots that end at the first row; infinite unless all
    /// eigenvalues lie beyond what vectors that are orthogonal to 1e-9 may
    /// change.
    double
    first_of_inverse(const TridiagonalMatrix &K)
    {
      const double          round_off = 1e-9;
      const Eigen::VectorXd of_rows =
        pivots({K.diagonal.reverse().array() - round_off, K.beside.reverse()});
      return (of_rows.array() > 0.).all() ?
        1. / of_rows[of_rows.size() - 1] :
        std::numeric_limits<double>::infinity();
    }
  } // namespace



  void
  RitzBasis::grow(const unsigned int n_wanted)
  {
    if (n_wanted > Q.cols() && !complete)
      {
        // twice as many, since all are copied; what is not used costs nothing
        const Eigen::Index room = 2 * n_wanted;
        Q.conservativeResize(u.size(), room);
        diagonal.conservativeResize(room);
        subdiagonal.conservativeResize(room);
      }
    while (n < n_wanted && !complete)
      {
        throw_if_interrupted();
        // The recurrence is that of A times the vectors. A recurrence of the
        // vectors beside it would part from it by round-off that grows.
        A_candidate = n == 0 ? u : M_last;
        if (n > 0)
          A_candidate -= diagonal[n - 1] * A_last;
        if (n > 1)
          A_candidate -= subdiagonal[n - 2] * A_before;
        matrices.solve(sigma, A_candidate, candidate);
        const double norm = orthogonalize();
        complete = n == Q.rows() || (n > 0 && norm * sigma <= least_coupling);
        if (complete)
          return;
        Q.col(n) = candidate / norm;
        A_before.swap(A_last);
        A_last           = A_candidate / norm;
        M_last.noalias() = as_eigen(matrices.discretization.mass()) * Q.col(n);
        diagonal[n]      = Q.col(n).dot(M_last);
        // T is positive, whatever round-off makes of it
        last_pivot = diagonal[n] - (n > 0 ? norm * norm / last_pivot : 0.);
        complete   = !(last_pivot > 0.);
        if (complete)
          return;
        if (n == 0)
          load_norm = norm;
        else
          subdiagonal[n - 1] = norm;
        ++n;
        ++matrices.work.ritz_vectors;
      }
  }



  double
  RitzBasis::orthogonalize()
  {
    double norm = norm_of_candidate();
    if (norm == 0.)
      return norm; // which nothing can be divided by
    if (n == 0)
      {
        overlaps_last = Eigen::ArrayXd::Ones(1);
        return norm;
      }
    Eigen::ArrayXd overlaps = expected_overlaps(norm);
    const double   expected = overlaps.abs().maxCoeff();
    // the first vectors show the round-off of a solve
    const bool begins_two = n < 4 ||
      (!is_second &&
       (expected > allowed_overlap || n >= looked_at + most_without_look));
    if (begins_two || is_second)
      {
        const Eigen::VectorXd removed = remove_overlaps();
        const double          left    = norm_of_candidate();
        if (!(removed.norm() < most_overlap * left))
          return 0.;
        if (begins_two) // what is expected is ten times what was seen
          noise = std::max(round_off,
                           noise *
                             std::max(0.1,
                                      10. * removed.cwiseAbs().maxCoeff() /
                                        (norm * expected)));
        norm      = left;
        looked_at = n;
        overlaps.setConstant(noise);
      }
    // the recurrence has two vectors to bring overlaps back from
    is_second       = begins_two;
    overlaps_before = overlaps_last;
    overlaps_last.resize(n + 1);
    overlaps_last << overlaps, 1.;
    return norm;
  }



  Eigen::ArrayXd
  RitzBasis::expected_overlaps(const double norm) const
  {
    const Eigen::Index   m     = n - 1;
    const Eigen::ArrayXd alpha = diagonal.head(n), beta = subdiagonal.head(m);
    Eigen::ArrayXd       result = Eigen::ArrayXd::Zero(n);
    if (m > 0)
      {
        result.head(m) = beta * overlaps_last.tail(m) +
          (alpha.head(m) - alpha[m]) * overlaps_last.head(m) -
          beta[m - 1] * overlaps_before;
        result.segment(1, m - 1) +=
          beta.head(m - 1) * overlaps_last.head(m - 1);
        result[m] = -beta[m - 1] * overlaps_last[m - 1];
      }
    return (result +
            (result < 0.).select(-noise, Eigen::ArrayXd::Constant(n, noise)) /
              sigma) /
      norm;
  }



  Eigen::VectorXd
  RitzBasis::remove_overlaps()
  {
    Eigen::VectorXd overlaps(n), sum = Eigen::VectorXd::Zero(Q.rows());
    // few vectors at a time stay in the cache
    for (Eigen::Index k = 0, some = 8; k < n; k += some)
      {
        const auto these = Q.middleCols(k, std::min<Eigen::Index>(some, n - k));
        const Eigen::VectorXd overlap = these.transpose() * A_candidate;
        sum.noalias() += these * overlap;
        overlaps.segment(k, overlap.size()) = overlap;
      }
    candidate -= sum;
    // A times the candidate would have more round-off than its recurrence
    A_candidate -= as_eigen(matrices.discretization.stiffness()) * sum +
      sigma * (as_eigen(matrices.discretization.mass()) * sum);
    return overlaps;
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



  ReducedSystem::ReducedSystem(const RitzBasis   &basis,
                               const unsigned int n,
                               const unsigned int n_terminator)
    : SemidiscreteSystem(basis.load() *
                           Eigen::VectorXd::Unit(n + n_terminator, 0),
                         basis.matrices.damping)
    , n_vectors(n)
    , basis(basis)
    , mass(continued_mass(basis, n, n_terminator))
    , stiffness{1. - basis.sigma * mass.diagonal.array(),
                -basis.sigma * mass.beside}
    , compliance(basis.matrices.discretization.is_free() ?
                   std::numeric_limits<double>::infinity() :
                   1.001 * basis.load() * basis.load() *
                     first_of_inverse(stiffness))
  {}



  void
  ReducedSystem::solve(const double           c,
                       const Eigen::VectorXd &b,
                       Eigen::VectorXd       &x)
  {
    const Eigen::Index n_beside = stiffness.beside.size();
    if (c != factorized_for)
      {
        const TridiagonalMatrix sum = {stiffness.diagonal + c * mass.diagonal,
                                       stiffness.beside + c * mass.beside};
        inverse_pivots              = pivots(sum).cwiseInverse();
        factor         = sum.beside.cwiseProduct(inverse_pivots.head(n_beside));
        factorized_for = c;
      }
    x = b;
    for (Eigen::Index i = 0; i < n_beside; ++i)
      x[i + 1] -= factor[i] * x[i];
    x.array() *= inverse_pivots.array();
    for (Eigen::Index i = n_beside - 1; i >= 0; --i)
      x[i] -= factor[i] * x[i + 1];
  }
} // namespace PlateImpact
