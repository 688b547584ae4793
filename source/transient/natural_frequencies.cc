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
#include <Epetra_Operator.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace PlateImpact
{
  namespace
  {
    /// (K + c M)^{-1} M by the factorization of a system.
    class ShiftInvert : public Epetra_Operator
    {
    public:
      ShiftInvert(const Epetra_CrsMatrix &mass, FullSystem &system)
        : mass(mass)
        , system(system)
      {}

      int
      Apply(const Epetra_MultiVector &X, Epetra_MultiVector &Y) const override
      {
        Eigen::VectorXd Mx, y;
        for (int column = 0; column < X.NumVectors(); ++column)
          {
            system.multiply_mass(
              Eigen::Map<const Eigen::VectorXd>(X[column], X.MyLength()),
              Mx);
            system.solve(Mx, y);
            Eigen::Map<Eigen::VectorXd>(Y[column], Y.MyLength()) = y;
          }
        return 0;
      }

      int
      ApplyInverse(const Epetra_MultiVector &,
                   Epetra_MultiVector &) const override
      {
        return -1;
      }

      int
      SetUseTranspose(const bool use_transpose) override
      {
        return use_transpose ? -1 : 0;
      }

      double
      NormInf() const override
      {
        return 0.;
      }

      const char *
      Label() const override
      {
        return "(K + c M)^-1 M";
      }

      bool
      UseTranspose() const override
      {
        return false;
      }

      bool
      HasNormInf() const override
      {
        return false;
      }

      const Epetra_Comm &
      Comm() const override
      {
        return mass.Comm();
      }

      const Epetra_Map &
      OperatorDomainMap() const override
      {
        return mass.OperatorDomainMap();
      }

      const Epetra_Map &
      OperatorRangeMap() const override
      {
        return mass.OperatorRangeMap();
      }

    private:
      const Epetra_CrsMatrix &mass;
      FullSystem             &system;
    };



    /// Of the order of the square of the lowest frequency: bending of a square
    /// of the area of the mesh. [1/s^2]
    double
    shift(const PlateDiscretization &discretization)
    {
      const PlateSection &section = discretization.section();
      double              area    = 0.;
      for (const auto &cell : discretization.mesh().active_cell_iterators())
        area += cell->measure();
      return section.mean_bending_stiffness() / section.mass_per_area /
        (area * area);
    }



    /// Squares of frequencies, by Rayleigh's quotient of the modes with the
    /// largest eigenvalues theta of (K + c M)^{-1} M, ascending. [1/s^2]
    std::vector<double>
    lowest_squares(const Epetra_CrsMatrix &mass,
                   FullSystem             &system,
                   const double            c,
                   const int               n)
    {
      using Problem =
        Anasazi::BasicEigenproblem<double, Epetra_MultiVector, Epetra_Operator>;
      // squares have modes in pairs of one frequency, which a single vector
      // does not tell apart
      const int  n_unknowns = mass.NumMyRows();
      const int  block_size = n_unknowns < 20 ? 1 : 2;
      const auto start      = Teuchos::rcp(
        new Epetra_MultiVector(mass.OperatorDomainMap(), block_size));
      // the same on every machine, and not orthogonal to a low mode
      for (int i = 0; i < start->MyLength(); ++i)
        {
          (*start)[block_size - 1][i] = std::cos(3. * i);
          (*start)[0][i]              = 1. + 0.5 * std::sin(1. + i);
        }
      const auto problem = Teuchos::rcp(
        new Problem(Teuchos::rcp(new ShiftInvert(mass, system)),
                    Teuchos::rcpFromRef<const Epetra_Operator>(mass),
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
      Anasazi::
        BlockKrylovSchurSolMgr<double, Epetra_MultiVector, Epetra_Operator>
          solver(problem, parameters);
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
      Eigen::VectorXd     Kx, Mx;
      for (int mode = 0; mode < solution.numVecs; ++mode)
        {
          const Eigen::VectorXd x =
            Eigen::Map<const Eigen::VectorXd>((*solution.Evecs)[mode],
                                              n_unknowns);
          system.multiply_stiffness(x, Kx);
          system.multiply_mass(x, Mx);
          const double square   = x.dot(Kx) / x.dot(Mx),
                       by_theta = 1. / solution.Evals[mode].realpart - c;
          // a motion as a rigid body has none
          if (std::abs(square - by_theta) > 1e-2 * std::abs(square) + 1e-6 * c)
            throw ComputationError(
              "round-off hides the lowest natural frequencies");
          result.push_back(square);
        }
      std::sort(result.begin(), result.end());
      return result;
    }
  } // namespace



  std::vector<double>
  natural_frequencies(const PlateDiscretization &discretization,
                      FullSystem                &system,
                      const unsigned int         n)
  {
    // planes of symmetry let a free plate move, but not turn across them
    const unsigned int n_rigid  = !discretization.is_free() ? 0 :
       discretization.n_parts() > 2.                        ? 1 :
       discretization.n_parts() > 1.                        ? 2 :
                                                              3;
    const unsigned int n_wanted = std::min(n, discretization.n_unknowns() / 4);
    if (n_wanted == 0)
      return {};
    const double c = shift(discretization);
    system.factorize(c);
    const std::vector<double> squares =
      lowest_squares(discretization.mass(), system, c, n_wanted + n_rigid);
    std::vector<double> result;
    for (std::size_t mode = n_rigid; mode < squares.size(); ++mode)
      {
        // what is left of a rigid body's, if it is not less by far
        if (squares[mode] < 1e-6 * c)
          throw ComputationError(
            "round-off hides the lowest natural frequencies");
        result.push_back(std::sqrt(squares[mode]) / (2. * std::acos(-1.)));
      }
    return result;
  }
} // namespace PlateImpact
