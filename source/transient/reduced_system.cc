#include "plate_impact/transient/reduced_system.h"

#include "plate_impact/transient/plate_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace PlateImpact
{
  namespace
  {
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
                   unsigned int       n_terminator)
    {
      if (basis.is_complete() && n == basis.n_vectors())
        n_terminator = 0;
      const TridiagonalMatrix T       = {basis.mass_diagonal().head(n),
                                         basis.mass_subdiagonal().head(n - 1)};
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
      const double          round_off = 1e-9;
      const Eigen::VectorXd of_rows =
        pivots({K.diagonal.reverse().array() - round_off, K.beside.reverse()});
      return (of_rows.array() > 0.).all() ?
        1. / of_rows[of_rows.size() - 1] :
        std::numeric_limits<double>::infinity();
    }
  } // namespace



  ReducedSystem::ReducedSystem(const RitzBasis   &basis,
                               const unsigned int n,
                               const unsigned int n_terminator)
    : ReducedSystem(basis, n, continued_mass(basis, n, n_terminator))
  {}



  ReducedSystem::ReducedSystem(const RitzBasis         &basis,
                               const unsigned int       n,
                               const TridiagonalMatrix &mass)
    : SemidiscreteSystem(basis.load() *
                           Eigen::VectorXd::Unit(mass.diagonal.size(), 0),
                         basis.matrices.damping)
    , basis(basis)
    , n(n)
    , mass(mass)
    , stiffness(stiffness_to(mass, basis.sigma))
    , compliance(basis.matrices.discretization.is_free() ?
                   std::numeric_limits<double>::infinity() :
                   1.001 * basis.load() * basis.load() *
                     first_of_inverse(stiffness))
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



  std::unique_ptr<PlateMotion>
  ReducedSystem::motion(const NewmarkScheme &scheme)
  {
    return std::make_unique<PlateStepper>(scheme, *this);
  }
} // namespace PlateImpact
