#pragma once

#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/linear_solver.h"

#include <EpetraExt_MatrixMatrix.h>

#include <memory>
#include <optional>
#include <utility>

namespace PlateImpact
{
  /// K + c M of a mesh, factorized for one c after another.
  class EffectiveStiffness
  {
  public:
    /// @param discretization  assembled; must outlive this object
    EffectiveStiffness(const PlateDiscretization &discretization,
                       const SolverType           solver_type)
      : discretization(discretization)
      , solver_type(solver_type)
      , solver(make_solver())
    {}

    /// Does nothing when the last factorization was for the same c.
    void
    factorize(const double c)
    {
      if (c == factorized_for)
        return;
      factorized_for.reset();
      auto sum = std::make_unique<Epetra_CrsMatrix>(discretization.stiffness());
      add_mass(c, *sum);
      solver->factorize(std::move(sum));
      factorized_for = c;
    }

    /// (K + c M) x = b.
    void
    solve(const double c, const Eigen::VectorXd &b, Eigen::VectorXd &x)
    {
      factorize(c);
      solver->solve(b, x);
    }

    /// Adds c M to a matrix with the entries of K, which are more.
    void
    add_mass(const double c, Epetra_CrsMatrix &matrix) const
    {
      EpetraExt::MatrixMatrix::Add(discretization.mass(),
                                   /*transpose=*/false,
                                   c,
                                   matrix,
                                   1.);
    }

    /// For another matrix with the entries of K; this object must outlive it.
    std::unique_ptr<LinearSolver>
    make_solver()
    {
      return make_linear_solver(solver_type, done);
    }

    const SolverWork &
    work() const
    {
      return done;
    }

    const PlateDiscretization &discretization;

    double damping = 0.; ///< as SemidiscreteSystem::damping() [s]

  private:
    const SolverType                    solver_type;
    SolverWork                          done;
    const std::unique_ptr<LinearSolver> solver;
    std::optional<double>               factorized_for; ///< c [1/s^2]
  };
} // namespace PlateImpact
