#pragma once

#include "plate_impact/transient/ritz_basis.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <optional>

namespace PlateImpact
{
  /// A symmetric matrix of three diagonals.
  struct TridiagonalMatrix
  {
    Eigen::VectorXd diagonal, beside;
  };


  /// The plate in the first vectors of a basis: M = T and K = I - sigma T are
  /// tridiagonal, a product or a solve costs a few operations per vector. A
  /// chain, in other words, that is struck at its first vector.
  ///
  /// Waves would come back from its end. Vectors beyond the first can be
  /// assumed in place of computed: away from the load the coefficients of T are
  /// about those of a continuous spectrum from 0 to infinity, 1/(2 sigma) and
  /// 1/(4 sigma) all along, and a uniform chain of these joined to the end, the
  /// terminator of the recursion method (Haydock, Heine & Kelly 1972,
  /// doi:10.1088/0022-3719/5/20/004), takes the waves up. What lies in it has
  /// no displacements on the plate. The joint is such that K and M stay
  /// positive.
  class ReducedSystem : public SemidiscreteSystem
  {
  public:
    /// @param basis        must outlive the system
    /// @param n            vectors used, at most basis.n_vectors()
    /// @param n_terminator  length of the terminator; none is joined to all
    ///                      vectors of a complete basis
    ReducedSystem(const RitzBasis &basis,
                  unsigned int     n,
                  unsigned int     n_terminator = 0);

    void
    multiply_stiffness(const Eigen::VectorXd &x,
                       Eigen::VectorXd       &y) const override;
    void
    solve(double c, const Eigen::VectorXd &b, Eigen::VectorXd &x) override;

    double
    static_compliance() override
    {
      return compliance;
    }

    std::unique_ptr<PlateMotion>
    motion(const NewmarkScheme &scheme) override;

    Span
    span(const Eigen::Ref<const Eigen::MatrixXd> &states) const override
    {
      return {vectors(), states.topRows(n)};
    }

    unsigned int
    n_states_at_once() const override
    {
      return 500;
    }

    unsigned int
    n_vectors() const
    {
      return n;
    }

    /// Unknowns of the mesh by the vectors used.
    Eigen::Ref<const Eigen::MatrixXd>
    vectors() const
    {
      return basis.vectors().leftCols(n);
    }

  private:
    ReducedSystem(const RitzBasis         &basis,
                  unsigned int             n,
                  const TridiagonalMatrix &mass);

    const RitzBasis        &basis;
    const unsigned int      n;
    const TridiagonalMatrix mass;      ///< T [s^2], with what is joined to it
    const TridiagonalMatrix stiffness; ///< I - sigma T
    const double            compliance;
    std::optional<double>   factorized_for;         ///< c [1/s^2]
    Eigen::VectorXd         inverse_pivots, factor; ///< of K + c M
  };
} // namespace PlateImpact
