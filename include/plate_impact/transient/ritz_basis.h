#pragma once

#include "plate_impact/transient/full_system.h"

#include <Eigen/Core>

#include <map>

namespace PlateImpact
{
  /// Load-dependent Ritz vectors of a plate (Wilson, Yuan & Dickens 1982,
  /// doi:10.1002/eqe.4290100606; Nour-Omid & Clough 1984,
  /// doi:10.1002/eqe.4290120410): since the contact force always has the same
  /// shape u, the response stays close to the Krylov space of (K + sigma M)^-1
  /// M that begins with the response (K + sigma M)^-1 u to the load itself. The
  /// first vector is the static correction, which a basis of eigenmodes lacks.
  ///
  /// Lanczos' recurrence in the inner product of A = K + sigma M: with Q^T A Q
  /// = I the projected mass T = Q^T M Q is tridiagonal, the projected stiffness
  /// I - sigma T, and the load a multiple of the first unit vector; A times a
  /// new vector is known before it is solved for. A vector costs one solve, one
  /// product with M, and one look at all vectors before it, which keeps them
  /// orthogonal (Simon 1984, doi:10.1090/S0025-5718-1984-0725988-X).
  class RitzBasis
  {
  public:
    /// @param system  must outlive the basis
    /// @param sigma   1/s^2, above 0, so that plates that are free to move have
    ///               a basis too
    RitzBasis(FullSystem &system, double sigma)
      : matrices(*system.matrices)
      , sigma(sigma)
      , u(system.load())
    {}

    EffectiveStiffness &matrices; ///< of the plate
    const double        sigma;

    /// Adds vectors, one solve each, until there are n or, when the space is
    /// exhausted, as many as there can be.
    void
    grow(unsigned int n);

    unsigned int
    n_vectors() const
    {
      return n;
    }

    /// Whether further vectors would be round-off, or hardly coupled to these:
    /// the basis then holds every motion that the load can excite.
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

    /// Diagonal of T, the mass in the basis. [s^2]
    Eigen::Ref<const Eigen::VectorXd>
    mass_diagonal() const
    {
      return diagonal.head(n);
    }

    /// Its other diagonals. [s^2]
    Eigen::Ref<const Eigen::VectorXd>
    mass_subdiagonal() const
    {
      return subdiagonal.head(n - 1);
    }

    /// The load in the basis, this times the first unit vector.
    double
    load() const
    {
      return load_norm;
    }

  private:
    /// Adds a vector, unless nothing is left of it.
    void
    append();
    /// Removes what round-off has left of earlier vectors in the candidate.
    /// @return norm_of_candidate() after that; 0 when that is round-off too
    double
    orthogonalize();
    double
    norm_of_candidate() const;

    const Eigen::VectorXd &u;
    unsigned int           n        = 0;
    bool                   complete = false;
    bool            is_second = false; ///< next to one that had lost digits
    double          load_norm = 0., last_pivot = 0.; ///< of T
    Eigen::MatrixXd Q;                               ///< with room for more
    Eigen::VectorXd diagonal, subdiagonal;
    Eigen::VectorXd candidate, A_candidate; ///< becomes the next vector
    Eigen::VectorXd A_last, A_before;       ///< A times the last two vectors
    Eigen::VectorXd M_last;                 ///< M times the last vector
  };


  /// A mesh under one load, and the bases that were made of it, by the half
  /// octave of the root of their shift. Steps of any length and number share
  /// them.
  struct LoadedMesh
  {
    FullSystem               system;
    std::map<int, RitzBasis> bases;

    unsigned int
    n_vectors() const
    {
      unsigned int n = 0;
      for (const auto &[half_octave, basis] : bases)
        n += basis.n_vectors();
      return n;
    }
  };
} // namespace PlateImpact
