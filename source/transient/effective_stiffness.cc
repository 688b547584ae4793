#include "plate_impact/transient/effective_stiffness.h"

#include <deal.II/base/timer.h>

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



  void
  Factorization::factorize(std::unique_ptr<Epetra_CrsMatrix> matrix)
  {
    const dealii::Timer timer;
    factorized = std::move(matrix);
    solver->factorize(*factorized);
    ++work.factorizations;
    work.factorization_seconds += timer.wall_time();
  }



  void
  Factorization::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    solver->solve(b, x);
    ++work.linear_solves;
  }



  void
  EffectiveStiffness::factorize(const double c)
  {
    if (c == factorized_for)
      return;
    factorized_for.reset();
    auto sum = std::make_unique<Epetra_CrsMatrix>(discretization.stiffness());
    add_mass(c, *sum);
    factors.factorize(std::move(sum));
    factorized_for = c;
  }



  void
  EffectiveStiffness::add_mass(const double c, Epetra_CrsMatrix &matrix) const
  {
    add(c, discretization.mass(), matrix);
  }



  void
  EffectiveStiffness::solve(const double           c,
                            const Eigen::VectorXd &b,
                            Eigen::VectorXd       &x)
  {
    factorize(c);
    factors.solve(b, x);
  }



  void
  EffectiveStiffness::multiply(const double           c,
                               const Eigen::VectorXd &x,
                               Eigen::VectorXd       &y)
  {
    factorize(c);
    y.noalias() = as_eigen(factors.matrix()) * x;
  }
} // namespace PlateImpact
