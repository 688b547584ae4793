#include "plate_impact/transient/ritz_basis.h"

#include "plate_impact/base/exceptions.h"

#include <algorithm>
#include <cmath>

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



  void
  RitzBasis::grow(const unsigned int n_wanted)
  {
    if (n_wanted <= n || complete)
      return;
    if (n_wanted > Q.cols())
      {
        // twice as many, since all are copied; what is not used costs nothing
        const Eigen::Index room = 2 * n_wanted;
        Q.conservativeResize(u.size(), room);
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
    A_candidate = n == 0 ? u : M_last;
    matrices.solve(sigma, A_candidate, candidate);
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
    A_candidate = as_eigen(matrices.discretization.stiffness()) * candidate +
      sigma * (as_eigen(matrices.discretization.mass()) * candidate);
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

} // namespace PlateImpact
