#pragma once

#include <deal.II/base/timer.h>

#include "plate_impact/base/choices.h"

#include <Eigen/SparseCore>
#include <Epetra_CrsMatrix.h>

#include <memory>
#include <utility>

namespace PlateImpact
{
  /// The arrays of a matrix, for products without the allocations of
  /// Epetra_CrsMatrix::Multiply().
  Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>>
  as_eigen(const Epetra_CrsMatrix &matrix);


  /// What solvers have done.
  struct SolverWork
  {
    unsigned int factorizations = 0, linear_solves = 0;
    double       factorization_seconds = 0.; ///< wall time [s]
  };


  /// Direct solver for symmetric positive definite matrices of one sparsity,
  /// one at a time, and many right hand sides.
  class LinearSolver
  {
  public:
    /// @param work  is added to; must outlive this object
    explicit LinearSolver(SolverWork &work)
      : work(work)
    {}

    virtual ~LinearSolver() = default;

    /// @throws ComputationError when it is not positive definite
    void
    factorize(std::unique_ptr<Epetra_CrsMatrix> matrix)
    {
      const dealii::Timer timer;
      factorized = std::move(matrix);
      factorize_matrix(*factorized);
      ++work.factorizations;
      work.factorization_seconds += timer.wall_time();
    }

    /// For x, by the last factorization; both have the size of the matrix.
    void
    solve(const Eigen::VectorXd &right_hand_side, Eigen::VectorXd &x)
    {
      solve_factorized(right_hand_side, x);
      ++work.linear_solves;
    }

  private:
    /// The matrix stays unchanged for solve_factorized().
    virtual void
    factorize_matrix(Epetra_CrsMatrix &matrix) = 0;
    virtual void
    solve_factorized(const Eigen::VectorXd &right_hand_side,
                     Eigen::VectorXd       &x) = 0;

    SolverWork                       &work;
    std::unique_ptr<Epetra_CrsMatrix> factorized;
  };

  /// The solver that the scene names: `CHOLMOD` (supernodal Cholesky, minimum
  /// degree ordering) or `KLU` (LU of Trilinos' Amesos).
  std::unique_ptr<LinearSolver>
  make_linear_solver(SolverType type, SolverWork &work);
} // namespace PlateImpact
