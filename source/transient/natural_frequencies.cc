#include "plate_impact/transient/natural_frequencies.h"

#include "plate_impact/base/exceptions.h"

// Anasazi's and Teuchos' templates make warnings of their own.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziEpetraAdapter.hpp>
#pragma GCC diagnostic pop
#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

using Vectors        = Epetra_MultiVector;
using VectorOperator = std::function<void(const Vectors &, Vectors &)>;

/// How Anasazi applies an operator.
template <>
struct Anasazi::OperatorTraits<double, Vectors, VectorOperator>
{
  static void
  Apply(const VectorOperator &apply, const Vectors &X, Vectors &Y)
  {
    apply(X, Y);
  }
};

namespace PlateImpact
{
  namespace
  {
    /// Of the square of bending, what round-off makes of a motion as a rigid
    /// body, 1e-5 on thin plates and fine meshes; a free strip bends with more
    /// until it is 100 times as long as wide.
    constexpr double rigid = 1e-4;



    /// Squares of frequencies, by Rayleigh's quotient of the modes with the
    /// largest eigenvalues theta of (K + c M)^{-1} M, ascending. [1/s^2]
    std::vector<double>
    lowest_squares(EffectiveStiffness &matrices, const double c, const int n)
    {
      using Vector = Eigen::Map<const Eigen::VectorXd>;
      using Problem =
        Anasazi::BasicEigenproblem<double, Vectors, VectorOperator>;
      const Epetra_CrsMatrix &mass = matrices.discretization.mass();
      const auto              K = as_eigen(matrices.discretization.stiffness()),
                 M              = as_eigen(mass);
      const VectorOperator multiply_mass = [&](const Vectors &X, Vectors &Y) {
        mass.Apply(X, Y);
      };
      const VectorOperator shift_invert = [&](const Vectors &X, Vectors &Y) {
        Eigen::VectorXd y;
        for (int column = 0; column < X.NumVectors(); ++column)
          {
            matrices.solve(c, M * Vector(X[column], X.MyLength()), y);
            std::copy(y.begin(), y.end(), Y[column]);
          }
      };
      // squares have modes in pairs of one frequency, which a single vector
      // does not tell apart
      const int  n_unknowns = mass.NumMyRows();
      const int  block_size = n_unknowns < 20 ? 1 : 2;
      const auto start =
        Teuchos::rcp(new Vectors(mass.DomainMap(), block_size));
      // the same on every machine, and not orthogonal to a low mode
      for (int i = 0; i < start->MyLength(); ++i)
        {
          (*start)[block_size - 1][i] = std::cos(3. * i);
          (*start)[0][i]              = 1. + 0.5 * std::sin(1. + i);
        }
      const auto problem =
        Teuchos::rcp(new Problem(Teuchos::rcpFromRef(shift_invert),
                                 Teuchos::rcpFromRef(multiply_mass),
                                 start));
      problem->setHermitian(true);
      problem->setNEV(n);
      problem->setProblem();

      Teuchos::ParameterList parameters;
      parameters.set("Which", "LM");
      parameters.set("Block Size", block_size);
      parameters.set("Num Blocks",
                     std::min(n_unknowns / block_size - 1, 2 * n + 8));
      parameters.set("Maximum Restarts", 100);
      parameters.set("Convergence Tolerance", 1e-9);
      parameters.set("Verbosity", Anasazi::Errors);
      Anasazi::BlockKrylovSchurSolMgr<double, Vectors, VectorOperator> solver(
        problem,
        parameters);
      try
        {
          if (solver.solve() != Anasazi::Converged)
            throw ComputationError("Anasazi does not find the " +
                                   std::to_string(n) +
                                   " lowest natural frequencies");
        }
      catch (const std::logic_error &error)
        {
          throw ComputationError("Anasazi fails to find natural frequencies: " +
                                 std::string(error.what()));
        }

      const auto         &solution = problem->getSolution();
      std::vector<double> result;
      for (int mode = 0; mode < solution.numVecs; ++mode)
        {
          const Vector x((*solution.Evecs)[mode], n_unknowns);
          const double square   = x.dot(K * x) / x.dot(M * x),
                       by_theta = 1. / solution.Evals[mode].realpart - c;
          // a motion as a rigid body has none
          if (std::abs(square - by_theta) > 1e-2 * std::abs(square) + rigid * c)
            throw ComputationError(
              "round-off hides the lowest natural frequencies");
          result.push_back(square);
        }
      std::sort(result.begin(), result.end());
      return result;
    }
  } // namespace



  std::vector<double>
  natural_frequencies(EffectiveStiffness &matrices, const unsigned int n)
  {
    const PlateDiscretization &discretization = matrices.discretization;
    const unsigned int         n_rigid = discretization.n_rigid_motions();
    const unsigned int n_wanted = std::min(n, discretization.n_unknowns() / 4);
    if (n_wanted == 0)
      return {};
    const double              c = discretization.square_of_bending();
    const std::vector<double> squares =
      lowest_squares(matrices, c, n_wanted + n_rigid);
    std::vector<double> result;
    for (std::size_t mode = n_rigid; mode < squares.size(); ++mode)
      {
        // what is left of a rigid body's, if it is not less by far
        if (squares[mode] < rigid * c)
          throw ComputationError(
            "round-off hides the lowest natural frequencies");
        result.push_back(std::sqrt(squares[mode]) / (2. * std::acos(-1.)));
      }
    return result;
  }
} // namespace PlateImpact
