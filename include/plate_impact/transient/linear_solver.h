#pragma once

#include <deal.II/base/timer.h>

#include "plate_impact/base/choices.h"
#include "plate_impact/plate/plate_discretization.h"

#include <Eigen/SparseCore>
#include <EpetraExt_MatrixMatrix.h>

#include <memory>
#include <optional>
#include <utility>

namespace PlateImpact
{
  /// The arrays of a matrix, for products without the allocations of
  /// Epetra_CrsMatrix::Multiply().
  inline Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>>
  as_eigen(const Epetra_CrsMatrix &matrix)
  {
    int    *rows, *columns;
    double *values;
    matrix.ExtractCrsDataPointers(rows, columns, values);
    return {matrix.NumMyRows(),
            matrix.NumMyCols(),
            matrix.NumMyNonzeros(),
            rows,
            columns,
            values};
  }


  /// What was made of a plate so far. Times are wall times.
  struct PlateWork
  {
    unsigned int loads          = 0; ///< with time steps
    unsigned int ritz_vectors   = 0; ///< a solve each
    unsigned int factorizations = 0, linear_solves = 0;
    double       assembly_seconds      = 0.; ///< of matrices and loads
    double       factorization_seconds = 0.;
  };


  /// Direct solver for symmetric positive definite matrices of one sparsity.
  class LinearSolver
  {
  public:
    /// @param work  is added to; must outlive this object
    explicit LinearSolver(PlateWork &work)
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

    PlateWork                        &work;
    std::unique_ptr<Epetra_CrsMatrix> factorized;
  };

  /// The solver that the scene names: `CHOLMOD` (supernodal Cholesky, minimum
  /// degree ordering) or `KLU` (LU of Trilinos' Amesos).
  std::unique_ptr<LinearSolver>
  make_linear_solver(SolverType type, PlateWork &work);


  /// K + c M of a mesh, factorized for one c after another.
  class EffectiveStiffness
  {
  public:
    /// @param discretization  assembled; must outlive this object
    EffectiveStiffness(const PlateDiscretization &discretization,
                       const SolverType           solver_type)
      : discretization(discretization)
      , solver_type(solver_type)
      , solver(make_linear_solver(solver_type, work))
    {}

    /// Does nothing when the last factorization was for the same c.
    void
    factorize(const double c)
    {
      if (c == factorized_for)
        return;
      factorized_for.reset();
      solver->factorize(sum(1., c));
      factorized_for = c;
    }

    /// (K + c M) x = b.
    void
    solve(const double c, const Eigen::VectorXd &b, Eigen::VectorXd &x)
    {
      factorize(c);
      solver->solve(b, x);
    }

    /// a K + c M, with the entries of K, which are more.
    std::unique_ptr<Epetra_CrsMatrix>
    sum(const double a, const double c) const
    {
      auto sum = std::make_unique<Epetra_CrsMatrix>(discretization.stiffness());
      EpetraExt::MatrixMatrix::Add(discretization.mass(),
                                   /*transpose=*/false,
                                   c,
                                   *sum,
                                   a);
      return sum;
    }

    const PlateDiscretization &discretization;

    double damping = 0.; ///< as SemidiscreteSystem::damping [s]

    PlateWork        work;
    const SolverType solver_type;

  private:
    const std::unique_ptr<LinearSolver> solver;
    std::optional<double>               factorized_for; ///< c [1/s^2]
  };
} // namespace PlateImpact
