#include "plate_impact/semidiscrete_plate.h"

#include <Epetra_Vector.h>

#include <utility>

namespace PlateImpact
{
  namespace
  {
    void
    multiply(const Epetra_CrsMatrix &matrix,
             const Eigen::VectorXd  &x,
             Eigen::VectorXd        &y)
    {
      y.resize(x.size());
      const Epetra_Vector x_view(View,
                                 matrix.DomainMap(),
                                 const_cast<double *>(x.data()));
      Epetra_Vector       y_view(View, matrix.RangeMap(), y.data());
      matrix.Multiply(/*TransA=*/false, x_view, y_view);
    }
  } // namespace



  MeshPlate::MeshPlate(const PlateModel             &model,
                       const Eigen::VectorXd        &load,
                       std::unique_ptr<LinearSolver> solver)
    : model(model)
    , u(load)
    , solver(std::move(solver))
  {}



  const Eigen::VectorXd &
  MeshPlate::load() const
  {
    return u;
  }



  void
  MeshPlate::set_load(const Eigen::VectorXd &load)
  {
    u = load;
  }



  void
  MeshPlate::multiply_stiffness(const Eigen::VectorXd &x,
                                Eigen::VectorXd       &y) const
  {
    multiply(model.stiffness(), x, y);
  }



  void
  MeshPlate::multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
  {
    multiply(model.mass(), x, y);
  }



  void
  MeshPlate::multiply_shifted(const double           c,
                              const Eigen::VectorXd &x,
                              Eigen::VectorXd       &y) const
  {
    Eigen::VectorXd Mx;
    multiply_mass(x, Mx);
    multiply_stiffness(x, y);
    y += c * Mx;
  }



  void
  MeshPlate::factorize(const double c)
  {
    if (c == factorized_for)
      return;
    factorized_for      = -1.;
    effective_stiffness = std::make_unique<Epetra_CrsMatrix>(model.stiffness());

    // K and M have the same entries in the same order
    const auto values = [](const Epetra_CrsMatrix &matrix) {
      int    *rows, *columns;
      double *values;
      matrix.ExtractCrsDataPointers(rows, columns, values);
      return Eigen::Map<Eigen::VectorXd>(values, matrix.NumMyNonzeros());
    };
    values(*effective_stiffness) += c * values(model.mass());
    solver->factorize(*effective_stiffness);
    factorized_for = c;
    ++factorizations;
  }



  double
  MeshPlate::factor_size() const
  {
    return solver->factor_size();
  }



  unsigned int
  MeshPlate::n_factorizations() const
  {
    return factorizations;
  }



  void
  MeshPlate::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    solver->solve(b, x);
  }
} // namespace PlateImpact
