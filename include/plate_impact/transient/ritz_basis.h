#pragma once

#include "plate_impact/transient/full_system.h"

#include <Eigen/Core>

#include <map>
#include <optional>

namespace PlateImpact
{
  /// A symmetric matrix of three diagonals.
  struct TridiagonalMatrix
  {
    Eigen::VectorXd diagonal, beside;

    /// y = A x of this matrix A.
    void
    multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
    {
      const Eigen::Index n_beside = beside.size();
      y                           = diagonal.cwiseProduct(x);
      y.head(n_beside) += beside.cwiseProduct(x.tail(n_beside));
      y.tail(n_beside) += beside.cwiseProduct(x.head(n_beside));
    }
  };


  /// Load-dependent Ritz vectors of a plate (Wilson, Yuan & Dickens 1982,
  /// doi:10.1002/eqe.4290100606; Nour-Omid & Clough 1984,
  /// doi:10.1002/eqe.4290120410): the Krylov space of A^-1 M, A = K + sigma M,
  /// that begins with the response A^-1 u to the load.
  ///
  /// Lanczos' recurrence: with Q^T A Q = I the projected mass T = Q^T M Q is
  /// tridiagonal, the stiffness I - sigma T, and the load a multiple of the
  /// first unit vector. A vector costs one solve and one product with M. Where
  /// a recurrence tells that round-off may have grown, a vector and the next
  /// are made orthogonal to all before (Simon 1984,
  /// doi:10.1090/S0025-5718-1984-0725988-X).
  class RitzBasis
  {
  public:
    /// @param system  must outlive the basis
    /// @param sigma   1/s^2, above 0, so that plates that are free to move have
    ///               a basis too
    RitzBasis(FullSystem &system, double sigma)
      : matrices(*system.matrices)
      , sigma(sigma)
      , u(system.load)
    {}

    EffectiveStiffness &matrices; ///< of the plate
    const double        sigma;

    /// Adds vectors until there are n or as many as there can be.
    void
    grow(unsigned int n);

    unsigned int
    n_vectors() const
    {
      return n;
    }

    /// Whether the basis holds every motion that the load can excite.
    bool
    is_complete() const
    {
      return complete;
    }

    /// Unknowns of the plate by number of vectors.
    Eigen::Ref<const Eigen::MatrixXd>
    vectors() const
    {
      return Q.leftCols(n);
    }

    /// T of the first vectors, the mass in the basis. [s^2]
    TridiagonalMatrix
    mass(const unsigned int n_first) const
    {
      return {diagonal.head(n_first), subdiagonal.head(n_first - 1)};
    }

    /// The load in the basis, this times the first unit vector.
    double
    load() const
    {
      return load_norm;
    }

  private:
    static constexpr double round_off = 1e-16;

    /// Removes what round-off has left of earlier vectors in the candidate,
    /// where that may matter.
    /// @return norm_of_candidate() after that; 0 when that is round-off too
    double
    orthogonalize();
    /// Products q_k^T A q of the vector q that the candidate becomes with those
    /// before, which Lanczos' recurrence makes of those of the last two vectors
    /// and the noise.
    /// @param norm  of the candidate
    Eigen::ArrayXd
    expected_overlaps(double norm) const;
    /// Removes earlier vectors from the candidate.
    /// @return the products q_k^T A candidate before
    Eigen::VectorXd
    remove_overlaps();
    double
    norm_of_candidate() const;

    const Eigen::VectorXd &u;
    unsigned int           n        = 0;
    bool                   complete = false;
    bool         is_second = false;     ///< of two that are made orthogonal
    unsigned int looked_at = 0;         ///< the last of such, by number
    double       noise     = round_off; ///< ten times that of a solve, relative
    /// Products with all up to themselves of the last vector and the one
    /// before, as expected.
    Eigen::ArrayXd  overlaps_last, overlaps_before;
    double          load_norm = 0., last_pivot = 0.; ///< of T
    Eigen::MatrixXd Q;                               ///< with room for more
    Eigen::VectorXd diagonal, subdiagonal;
    Eigen::VectorXd candidate, A_candidate; ///< becomes the next vector
    Eigen::VectorXd A_last, A_before;       ///< A times the last two vectors
    Eigen::VectorXd M_last;                 ///< M times the last vector
  };


  /// The plate in the first vectors of a basis, M = T and K = I - sigma T: a
  /// chain that is struck at its first vector. Waves would come back from its
  /// end. Since away from the load the coefficients of T are about those of a
  /// continuous spectrum, 1/(2 sigma) and 1/(4 sigma), a uniform chain of
  /// these, the terminator of the recursion method (Haydock, Heine & Kelly
  /// 1972, doi:10.1088/0022-3719/5/20/004), takes them up. It has no
  /// displacements on the plate. The joint is such that K and M stay positive.
  class ReducedSystem : public SemidiscreteSystem
  {
  public:
    /// @param basis        must outlive the system
    /// @param n            vectors used, at most basis.n_vectors()
    /// @param n_terminator  length of the terminator
    ReducedSystem(const RitzBasis &basis,
                  unsigned int     n,
                  unsigned int     n_terminator = 0);

    void
    multiply_stiffness(const Eigen::VectorXd &x,
                       Eigen::VectorXd       &y) const override
    {
      stiffness.multiply(x, y);
    }

    void
    multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const override
    {
      mass.multiply(x, y);
    }

    void
    solve(double c, const Eigen::VectorXd &b, Eigen::VectorXd &x) override;

    double
    static_compliance() override
    {
      return compliance;
    }

    Span
    span(const Eigen::Ref<const Eigen::MatrixXd> &states) const override
    {
      return {basis.vectors().leftCols(n_vectors), states.topRows(n_vectors)};
    }

    Eigen::MatrixXd
    states(const Span & /*span*/,
           const Eigen::MatrixXd &coordinates) const override
    {
      Eigen::MatrixXd result =
        Eigen::MatrixXd::Zero(load.size(), coordinates.cols());
      result.topRows(n_vectors) = coordinates;
      return result;
    }

    unsigned int
    n_states_at_once() const override
    {
      return 500;
    }

    const unsigned int n_vectors; ///< used

  private:
    const RitzBasis        &basis;
    const TridiagonalMatrix mass;      ///< T [s^2], with what is joined to it
    const TridiagonalMatrix stiffness; ///< I - sigma T
    const double            compliance;
    std::optional<double>   factorized_for;         ///< c [1/s^2]
    Eigen::VectorXd         inverse_pivots, factor; ///< of K + c M
  };


  /// A mesh under one load, and its bases by the half octave of the root of
  /// their shift, which steps of any length and number share.
  struct LoadedMesh
  {
    FullSystem               system;
    std::map<int, RitzBasis> bases;
  };
} // namespace PlateImpact
