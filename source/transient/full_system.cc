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



  EffectiveStiffness::EffectiveStiffness(
    const PlateDiscretization    &discretization,
    std::unique_ptr<LinearSolver> solver)
    : discretization(discretization)
    , solver(std::move(solver))
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
    ++factorizations;
    clock.charge(seconds);
  }



  void
  EffectiveStiffness::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    solver->solve(b, x);
    ++solves;
  }



  const Epetra_CrsMatrix &
  EffectiveStiffness::matrix() const
  {
    return *sum;
  }



  unsigned int
  EffectiveStiffness::n_factorizations() const
  {
    return factorizations;
  }



  unsigned int
  EffectiveStiffness::n_solves() const
  {
    return solves;
  }



  double
  EffectiveStiffness::factorization_seconds() const
  {
    return seconds;
  }



  FullSystem::FullSystem(const PlateDiscretization    &discretization,
                         const Eigen::VectorXd        &load,
                         std::unique_ptr<LinearSolver> solver)
    : FullSystem(std::make_shared<EffectiveStiffness>(discretization,
                                                      std::move(solver)),
                 load)
  {}



  FullSystem::FullSystem(
    std::shared_ptr<EffectiveStiffness> effective_stiffness,
    const Eigen::VectorXd              &load)
    : effective_stiffness(std::move(effective_stiffness))
    , u(load)
  {}



  const Eigen::VectorXd &
  FullSystem::load() const
  {
    return u;
  }



  void
  FullSystem::multiply_stiffness(const Eigen::VectorXd &x,
                                 Eigen::VectorXd       &y) const
  {
    multiply(effective_stiffness->discretization.stiffness(), x, y);
  }



  void
  FullSystem::multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
  {
    multiply(effective_stiffness->discretization.mass(), x, y);
  }



  void
  FullSystem::multiply_effective_stiffness(const Eigen::VectorXd &x,
                                           Eigen::VectorXd       &y)
  {
    effective_stiffness->factorize(c);
    multiply(effective_stiffness->matrix(), x, y);
  }



  void
  FullSystem::factorize(const double shift)
  {
    c = shift;
    effective_stiffness->factorize(c);
  }



  void
  FullSystem::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    // another load, or the static compliance, may have replaced it
    effective_stiffness->factorize(c);
    effective_stiffness->solve(b, x);
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
    if (is_free())
      return infinite;
    Eigen::VectorXd x, residual;
    try
      {
        effective_stiffness->factorize(0.);
        effective_stiffness->solve(u, x);
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
    return effective_stiffness->discretization.is_free();
  }
} // namespace PlateImpact
