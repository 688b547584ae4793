#pragma once

#include <deal.II/base/timer.h>

#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/linear_solver.h"

#include <Epetra_CrsMatrix.h>

#include <memory>
#include <optional>
#include <utility>

namespace PlateImpact
{
  /// What solvers have done.
  struct SolverWork
  {
    unsigned int factorizations = 0, linear_solves = 0;
    double       factorization_seconds = 0.; ///< wall time [s]
  };


  /// A matrix, factorized.
  class Factorization
  {
  public:
    /// @param work  is added to; must outlive this object
    Factorization(SolverType solver, SolverWork &work)
      : solver(make_linear_solver(solver))
      , work(work)
    {}

    /// @throws ComputationError when it is not positive definite
    void
    factorize(std::unique_ptr<Epetra_CrsMatrix> matrix)
    {
      const dealii::Timer timer;
      factorized = std::move(matrix);
      solver->factorize(*factorized);
      ++work.factorizations;
      work.factorization_seconds += timer.wall_time();
    }

    void
    solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
    {
      solver->solve(b, x);
      ++work.linear_solves;
    }

    const Epetra_CrsMatrix &
    matrix() const
    {
      return *factorized;
    }

  private:
    const std::unique_ptr<LinearSolver> solver;
    std::unique_ptr<Epetra_CrsMatrix>   factorized;
    SolverWork                         &work;
  };


  /// K + c M of a mesh, factorized for one c after another.
  class EffectiveStiffness
  {
  public:
    /// @param discretization  assembled; must outlive this object
    EffectiveStiffness(const PlateDiscretization &discretization,
                       SolverType                 solver)
      : discretization(discretization)
      , solver(solver)
      , factors(solver, done)
    {}

    /// Does nothing when the last factorization was for the same c.
    void
    factorize(double c);

    /// (K + c M) x = b.
    void
    solve(const double c, const Eigen::VectorXd &b, Eigen::VectorXd &x)
    {
      factorize(c);
      factors.solve(b, x);
    }

    /// y = (K + c M) x.
    void
    multiply(const double c, const Eigen::VectorXd &x, Eigen::VectorXd &y)
    {
      factorize(c);
      y.noalias() = as_eigen(factors.matrix()) * x;
    }

    /// Adds c M.
    void
    add_mass(double c, Epetra_CrsMatrix &matrix) const;

    /// For another matrix with the entries of K; this object must outlive it.
    Factorization
    make_factorization()
    {
      return {solver, done};
    }

    const SolverWork &
    work() const
    {
      return done;
    }

    const PlateDiscretization &discretization;

    double damping = 0.; ///< as SemidiscreteSystem::damping() [s]

  private:
    const SolverType      solver;
    SolverWork            done;
    Factorization         factors;
    std::optional<double> factorized_for; ///< c [1/s^2]
  };
} // namespace PlateImpact
