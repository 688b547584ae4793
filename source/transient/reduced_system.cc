#include "plate_impact/transient/reduced_system.h"

#include "plate_impact/transient/plate_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace PlateImpact
{
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



    /// T of the first n vectors, continued by the terminator.
    TridiagonalMatrix
    continued_mass(const RitzBasis   &basis,
                   const unsigned int n,
                   unsigned int       n_terminator)
    {
      if (basis.is_complete() && n == basis.n_vectors())
        n_terminator = 0;
      const TridiagonalMatrix T       = {basis.mass_diagonal().head(n),
                                         basis.mass_subdiagonal().head(n - 1)};
      const double            uniform = 0.25 / basis.shift();
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
                               const unsigned int n_terminator)
    : basis(basis)
    , n(n)
    , mass(continued_mass(basis, n, n_terminator))
    , stiffness(stiffness_to(mass, basis.shift()))
    , u(basis.load() * Eigen::VectorXd::Unit(mass.diagonal.size(), 0))
    , compliance(basis.matrices.discretization.is_free() ?
                   std::numeric_limits<double>::infinity() :
                   1.001 * u[0] * u[0] * first_of_inverse(stiffness))
    , inverse_pivots(u.size())
    , factor(u.size())
  {}



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
    factorized_for = c;
  }



  void
  ReducedSystem::solve(const double           c,
                       const Eigen::VectorXd &b,
                       Eigen::VectorXd       &x)
  {
    if (c != factorized_for)
      factorize(c);
    const Eigen::Index n = u.size();
    x                    = b;
    for (Eigen::Index i = 1; i < n; ++i)
      x[i] -= factor[i] * x[i - 1];
    x.array() *= inverse_pivots.array();
    for (Eigen::Index i = n - 1; i > 0; --i)
      x[i - 1] -= factor[i] * x[i];
  }



  std::unique_ptr<PlateMotion>
  ReducedSystem::motion(const NewmarkScheme &scheme)
  {
    return std::make_unique<PlateStepper>(scheme, *this);
  }
} // namespace PlateImpact
