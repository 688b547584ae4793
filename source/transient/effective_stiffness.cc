#include "plate_impact/transient/effective_stiffness.h"

#include <utility>

namespace PlateImpact
{
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
    // every entry of M has one in K; columns are in order
    int    *rows, *columns, *M_rows, *M_columns;
    double *values, *M_values;
    matrix.ExtractCrsDataPointers(rows, columns, values);
    discretization.mass().ExtractCrsDataPointers(M_rows, M_columns, M_values);
    for (int row = 0; row < matrix.NumMyRows(); ++row)
      for (int m = M_rows[row], k = rows[row]; m < M_rows[row + 1]; ++k)
        if (columns[k] == M_columns[m])
          values[k] += c * M_values[m++];
  }
} // namespace PlateImpact
