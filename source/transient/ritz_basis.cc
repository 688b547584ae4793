#include "plate_impact/transient/ritz_basis.h"

#include "plate_impact/base/exceptions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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
  } // namespace



  RitzBasis::RitzBasis(FullSystem &plate, const double sigma)
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
        // twice as many, since all are copied; what is not used costs nothing
        const Eigen::Index room = 2 * n_wanted;
        Q.conservativeResize(plate.load().size(), room);
        diagonal.conservativeResize(room);
        subdiagonal.conservativeResize(room);
      }
    while (n < n_wanted && !complete)
      append();
  }



  void
  RitzBasis::append()
  {
    // A times the candidate is what it is solved for
    plate.solve(n == 0 ? plate.load() : M_last, candidate);
    if (n == 0)
      A_candidate = plate.load();
    else if (n == 1)
      {
        candidate -= diagonal[0] * Q.col(0);
        A_candidate = M_last - diagonal[0] * A_last;
      }
    else
      {
        candidate -=
          diagonal[n - 1] * Q.col(n - 1) + subdiagonal[n - 2] * Q.col(n - 2);
        A_candidate =
          M_last - diagonal[n - 1] * A_last - subdiagonal[n - 2] * A_before;
      }
    const double norm = orthogonalize();
    if (n == Q.rows() || (n > 0 && norm * sigma <= least_coupling))
      {
        complete = true;
        return;
      }
    Q.col(n) = candidate / norm;
    A_before.swap(A_last);
    A_last = A_candidate / norm;
    plate.multiply_mass(Q.col(n), M_last);
    diagonal[n] = Q.col(n).dot(M_last);
    // T is positive, whatever round-off makes of it
    const double pivot =
      n == 0 ? diagonal[0] : diagonal[n] - norm * norm / last_pivot;
    if (!(pivot > 0.))
      {
        complete = true;
        return;
      }
    last_pivot = pivot;
    if (n == 0)
      load_norm = norm;
    else
      subdiagonal[n - 1] = norm;
    ++n;
  }



  double
  RitzBasis::orthogonalize()
  {
    const double norm = norm_of_candidate();
    if (n == 0)
      return norm;
    // Orthogonal to the root of round-off serves as well as to round-off. What
    // is lost is looked at every time: from one vector to the next it grows by
    // a factor of 2 on most plates, and of 1e5 on some.
    const Eigen::VectorXd overlap = Q.leftCols(n).transpose() * A_candidate;
    const bool has_lost           = overlap.cwiseAbs().maxCoeff() > 1e-9 * norm;
    // the recurrence has two vectors to bring overlaps back from
    const bool is_first = has_lost && !is_second;
    const bool acts     = has_lost || is_second;
    is_second           = is_first;
    if (!acts)
      return norm;
    candidate -= Q.leftCols(n) * overlap;
    plate.multiply_effective_stiffness(candidate, A_candidate);
    const double left = norm_of_candidate();
    return overlap.norm() < most_overlap * left ? left : 0.;
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
  RitzBasis::is_free() const
  {
    return plate.is_free();
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
    /// The pivot that elimination of all other rows, from the first on, leaves
    /// of the last.
    double
    last_pivot(const TridiagonalMatrix &A)
    {
      double pivot = A.diagonal[0];
      for (Eigen::Index i = 0; i < A.beside.size(); ++i)
        pivot = A.diagonal[i + 1] - A.beside[i] * A.beside[i] / pivot;
      return pivot;
    }



    /// T of the first n vectors, continued by a uniform string.
    TridiagonalMatrix
    continued_mass(const RitzBasis   &basis,
                   const unsigned int n,
                   unsigned int       n_beyond)
    {
      if (basis.is_complete() && n == basis.n_vectors())
        n_beyond = 0;
      const TridiagonalMatrix T       = {basis.mass_diagonal().head(n),
                                         basis.mass_subdiagonal().head(n - 1)};
      const double            uniform = 0.25 / basis.shift();
      TridiagonalMatrix       result  = {
               Eigen::VectorXd::Constant(n + n_beyond, 2. * uniform),
               Eigen::VectorXd::Constant(n + n_beyond - 1, uniform)};
      result.diagonal.head(n)   = T.diagonal;
      result.beside.head(n - 1) = T.beside;
      if (n_beyond > 0)
        {
          // Elimination leaves pivots above `uniform` all along the uniform
          // string, in T as in K, if the first is at least that: the coupling
          // leaves 2 uniform - coupling^2 / pivot.
          const TridiagonalMatrix K = {1. / basis.shift() - T.diagonal.array(),
                                       T.beside};
          const double pivot        = std::min(last_pivot(T), last_pivot(K));
          result.beside[n - 1]      = std::sqrt(uniform * std::max(0., pivot));
        }
      return result;
    }



    /// K + sigma M = I.
    TridiagonalMatrix
    stiffness_to(const TridiagonalMatrix &mass, const double sigma)
    {
      return {1. - sigma * mass.diagonal.array(), -sigma * mass.beside};
    }



    /// (K^-1)_11, from pivots that end at the first row; infinite unless all
    /// eigenvalues lie beyond what vectors that are orthogonal to 1e-9 may
    /// change.
    double
    first_of_inverse(const TridiagonalMatrix &K)
    {
      const double round_off = 1e-9;
      double       pivot     = 0.;
      for (Eigen::Index i = K.diagonal.size() - 1; i >= 0; --i)
        {
          const double eliminated =
            i < K.beside.size() ? K.beside[i] * K.beside[i] / pivot : 0.;
          pivot = K.diagonal[i] - round_off - eliminated;
          if (pivot <= 0.)
            return std::numeric_limits<double>::infinity();
        }
      return 1. / pivot;
    }
  } // namespace



  ReducedSystem::ReducedSystem(const RitzBasis   &basis,
                               const unsigned int n,
                               const unsigned int n_beyond)
    : basis(basis)
    , n(n)
    , mass(continued_mass(basis, n, n_beyond))
    , stiffness(stiffness_to(mass, basis.shift()))
    , u(basis.load() * Eigen::VectorXd::Unit(mass.diagonal.size(), 0))
    , compliance(basis.is_free() ?
                   std::numeric_limits<double>::infinity() :
                   1.001 * u[0] * u[0] * first_of_inverse(stiffness))
    , inverse_pivots(u.size())
    , factor(u.size())
  {}



  const Eigen::VectorXd &
  ReducedSystem::load() const
  {
    return u;
  }



  void
  ReducedSystem::multiply_stiffness(const Eigen::VectorXd &x,
                                    Eigen::VectorXd       &y) const
  {
    const Eigen::Index n_beside = stiffness.beside.size();
    y                           = stiffness.diagonal.cwiseProduct(x);
    y.head(n_beside) += stiffness.beside.cwiseProduct(x.tail(n_beside));
    y.tail(n_beside) += stiffness.beside.cwiseProduct(x.head(n_beside));
  }



  void
  ReducedSystem::factorize(const double c)
  {
    const Eigen::VectorXd diagonal = stiffness.diagonal + c * mass.diagonal,
                          beside   = stiffness.beside + c * mass.beside;
    inverse_pivots[0]              = 1. / diagonal[0];
    for (Eigen::Index i = 1; i < diagonal.size(); ++i)
      {
        factor[i]         = beside[i - 1] * inverse_pivots[i - 1];
        inverse_pivots[i] = 1. / (diagonal[i] - factor[i] * beside[i - 1]);
      }
  }



  void
  ReducedSystem::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    const Eigen::Index n = u.size();
    x                    = b;
    for (Eigen::Index i = 1; i < n; ++i)
      x[i] -= factor[i] * x[i - 1];
    x.array() *= inverse_pivots.array();
    for (Eigen::Index i = n - 1; i > 0; --i)
      x[i - 1] -= factor[i] * x[i];
  }



  double
  ReducedSystem::static_compliance() const
  {
    return compliance;
  }



  unsigned int
  ReducedSystem::n_vectors() const
  {
    return n;
  }



  Eigen::Ref<const Eigen::MatrixXd>
  ReducedSystem::vectors() const
  {
    return basis.vectors().leftCols(n);
  }



  Eigen::MatrixXd
  ReducedSystem::unknowns(const Eigen::Ref<const Eigen::MatrixXd> &states) const
  {
    return vectors() * states.topRows(n);
  }
} // namespace PlateImpact
