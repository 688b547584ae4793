#pragma once

#include "plate_impact/base/choices.h"

#include <Eigen/SparseCore>

#include <memory>

class Epetra_CrsMatrix;

namespace PlateImpact
{
  /// The arrays of a matrix, for products without the allocations of
  /// Epetra_CrsMatrix::Multiply().
  Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>>
  as_eigen(const Epetra_CrsMatrix &matrix);


  /// Direct solver for symmetric positive definite matrices of one sparsity,
  /// one at a time, and many right hand sides.
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// Factorizes a matrix; the caller keeps it unchanged for solve().
    /// @throws ComputationError when it is not positive definite
    virtual void
    factorize(Epetra_CrsMatrix &matrix) = 0;

    /// Solves for x; both have the size of the matrix.
    virtual void
    solve(const Eigen::VectorXd &right_hand_side, Eigen::VectorXd &x) = 0;
  };

  /// The solver that the scene names: `CHOLMOD` (supernodal Cholesky, minimum
  /// degree ordering) or `KLU` (LU of Trilinos' Amesos).
  std::unique_ptr<LinearSolver>
  make_linear_solver(SolverType type);
} // namespace PlateImpact
