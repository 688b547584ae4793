#include "plate_impact/transient/full_system.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/stage_clock.h"

#include <Eigen/SparseCore>

#include <limits>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Without the allocations of Epetra_CrsMatrix::Multiply().
    void
    multiply(const Epetra_CrsMatrix &matrix,
             const Eigen::VectorXd  &x,
             Eigen::VectorXd        &y)
    {
      int    *rows, *columns;
      double *values;
      matrix.ExtractCrsDataPointers(rows, columns, values);
      using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;
      y.noalias()    = Eigen::Map<const RowMajor>(matrix.NumMyRows(),
                                               matrix.NumMyCols(),
                                               matrix.NumMyNonzeros(),
                                               rows,
                                               columns,
                                               values) *
        x;
    }



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



  FullSystem::FullSystem(const PlateDiscretization    &discretization,
                         const Eigen::VectorXd        &load,
                         std::unique_ptr<LinearSolver> solver)
    : discretization(discretization)
    , u(load)
    , solver(std::move(solver))
  {}



  const Eigen::VectorXd &
  FullSystem::load() const
  {
    return u;
  }



  void
  FullSystem::set_load(const Eigen::VectorXd &load)
  {
    if (u.size() == load.size() && u == load)
      return;
    u = load;
    compliance.reset();
  }



  void
  FullSystem::multiply_stiffness(const Eigen::VectorXd &x,
                                 Eigen::VectorXd       &y) const
  {
    multiply(discretization.stiffness(), x, y);
  }



  void
  FullSystem::multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
  {
    multiply(discretization.mass(), x, y);
  }



  void
  FullSystem::multiply_effective_stiffness(const Eigen::VectorXd &x,
                                           Eigen::VectorXd       &y) const
  {
    multiply(*effective_stiffness, x, y);
  }



  void
  FullSystem::factorize(const double c)
  {
    if (c == factorized_for)
      return;
    StageClock clock;
    factorized_for.reset();
    effective_stiffness =
      std::make_unique<Epetra_CrsMatrix>(discretization.stiffness());
    add(c, discretization.mass(), *effective_stiffness);
    solver->factorize(*effective_stiffness);
    factorized_for = c;
    ++factorizations;
    clock.charge(seconds);
  }



  void
  FullSystem::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    solver->solve(b, x);
    ++solves;
  }



  double
  FullSystem::static_compliance()
  {
    if (!compliance)
      {
        const std::optional<double> before = factorized_for;
        compliance                         = computed_compliance();
        if (before)
          factorize(*before);
      }
    return *compliance;
  }



  double
  FullSystem::computed_compliance()
  {
    const double infinite = std::numeric_limits<double>::infinity();
    if (is_free())
      return infinite;
    Eigen::VectorXd x, residual;
    try
      {
        factorize(0.);
        solve(u, x);
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



  bool
  FullSystem::is_free() const
  {
    return discretization.is_free();
  }



  unsigned int
  FullSystem::n_factorizations() const
  {
    return factorizations;
  }



  unsigned int
  FullSystem::n_solves() const
  {
    return solves;
  }



  double
  FullSystem::factorization_seconds() const
  {
    return seconds;
  }
} // namespace PlateImpact
