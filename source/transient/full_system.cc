#include "plate_impact/transient/full_system.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/stage_clock.h"

#include <limits>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// A += c B, of which every entry has one in A. Columns are in order.
    void
    add(const double c, const Epetra_CrsMatrix &B, Epetra_CrsMatrix &A)
    {
      int    *A_rows, *A_columns, *B_rows, *B_columns;
      double *A_values, *B_values;
      A.ExtractCrsDataPointers(A_rows, A_columns, A_values);
      B.ExtractCrsDataPointers(B_rows, B_columns, B_values);
      for (int row = 0; row < B.NumMyRows(); ++row)
        for (int b = B_rows[row], a = A_rows[row]; b < B_rows[row + 1]; ++a)
          if (A_columns[a] == B_columns[b])
            A_values[a] += c * B_values[b++];
    }
  } // namespace



  EffectiveStiffness::EffectiveStiffness(
    const PlateDiscretization &discretization,
    const SolverType           solver)
    : discretization(discretization)
    , solver(make_linear_solver(solver))
  {}



  void
  EffectiveStiffness::factorize(const double c)
  {
    if (c == factorized_for)
      return;
    StageClock clock;
    factorized_for.reset();
    sum = std::make_unique<Epetra_CrsMatrix>(discretization.stiffness());
    add(c, discretization.mass(), *sum);
    solver->factorize(*sum);
    factorized_for = c;
    ++done.factorizations;
    clock.charge(done.factorization_seconds);
  }



  void
  EffectiveStiffness::solve(const double           c,
                            const Eigen::VectorXd &b,
                            Eigen::VectorXd       &x)
  {
    factorize(c);
    solver->solve(b, x);
    ++done.linear_solves;
  }



  void
  EffectiveStiffness::multiply(const double           c,
                               const Eigen::VectorXd &x,
                               Eigen::VectorXd       &y)
  {
    factorize(c);
    y.noalias() = as_eigen(*sum) * x;
  }



  FullSystem::FullSystem(std::shared_ptr<EffectiveStiffness> shared_matrices,
                         const Eigen::VectorXd              &load)
    : matrices(std::move(shared_matrices))
    , u(load)
  {}



  void
  FullSystem::multiply_stiffness(const Eigen::VectorXd &x,
                                 Eigen::VectorXd       &y) const
  {
    y.noalias() = as_eigen(matrices->discretization.stiffness()) * x;
  }



  void
  FullSystem::solve(const double           c,
                    const Eigen::VectorXd &b,
                    Eigen::VectorXd       &x)
  {
    matrices->solve(c, b, x);
  }



  double
  FullSystem::static_compliance()
  {
    if (!compliance)
      compliance = computed_compliance();
    return *compliance;
  }



  double
  FullSystem::computed_compliance()
  {
    const double infinite = std::numeric_limits<double>::infinity();
    if (matrices->discretization.is_free())
      return infinite;
    Eigen::VectorXd x, residual;
    try
      {
        solve(0., u, x);
      }
    catch (const ComputationError &)
      {
        // an element with spurious modes
        return infinite;
      }
    multiply_stiffness(x, residual);
    residual -= u;
    const double error = residual.norm() / u.norm();
    // a bound, beyond round-off
    return error < 1e-4 ? (1.001 + error) * u.dot(x) : infinite;
  }
} // namespace PlateImpact
