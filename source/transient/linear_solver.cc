#include "plate_impact/transient/linear_solver.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"

#include <Amesos.h>
#include <Amesos_BaseSolver.h>
#include <Eigen/CholmodSupport>
#include <Epetra_LinearProblem.h>
#include <Epetra_Vector.h>

#include <fmt/format.h>
#include <new>
#include <unistd.h>

// Present when the BLAS is OpenBLAS and when CHOLMOD was built with OpenMP.
extern "C" {
void
openblas_set_num_threads(int) __attribute__((weak));
void
omp_set_max_active_levels(int) __attribute__((weak));
}

namespace PlateImpact
{
  namespace
  {
    /// CHOLMOD. Ordering and symbolic factorization hold for all matrices.
    class CholmodSolver : public LinearSolver
    {
    public:
      explicit CholmodSolver(PlateWork &work)
        : LinearSolver(work)
      {
        // threads, four in CHOLMOD whatever the machine has, cost more than
        // they bring
        if (openblas_set_num_threads != nullptr)
          openblas_set_num_threads(1);
        if (omp_set_max_active_levels != nullptr)
          omp_set_max_active_levels(0);
        cholmod_common &common = cholesky.cholmod();
        // Dense blocks pay from some thousand unknowns on. Without them no BLAS
        // is called, whose kernels differ from processor to processor.
        common.supernodal        = CHOLMOD_AUTO;
        common.supernodal_switch = 80.; // operations per entry of the factor
        common.final_ll          = 1; // fails where K* is not positive definite
        common.nmethods          = 1;
        // METIS' nested dissection costs as much as twenty solves and makes
        // them faster by a few per cent, if at all, up to a million unknowns
        common.method[0].ordering = CHOLMOD_AMD;
        common.print              = 0;
      }

    private:
      void
      factorize_matrix(Epetra_CrsMatrix &matrix) override
      {
        // rows of a symmetric matrix are its columns
        const Eigen::SparseMatrix<double> A = as_eigen(matrix).transpose();
        if (!is_analyzed)
          {
            cholesky.analyzePattern(A);
            require_success(A.rows());
            is_analyzed = true;
          }
        // the system would end the process without a word
        const double bytes    = cholesky.cholmod().lnz * sizeof(double),
                     physical = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
          static_cast<double>(sysconf(_SC_PAGESIZE));
        if (bytes >= physical)
          throw ComputationError(fmt::format(
            "the factor of the effective stiffness matrix of {} unknowns needs "
            "{} of memory, but there is only {}; try fewer cells or a larger "
            "Adaptivity/Minimum cell size",
            A.rows(),
            number(bytes, "B"),
            number(physical, "B")));
        cholesky.factorize(A);
        require_success(A.rows());
      }

      void
      solve_factorized(const Eigen::VectorXd &right_hand_side,
                       Eigen::VectorXd       &x) override
      {
        x = cholesky.solve(right_hand_side);
        require_success(x.size());
      }

      void
      require_success(const Eigen::Index n_unknowns)
      {
        const int status = cholesky.cholmod().status;
        if (status == CHOLMOD_OUT_OF_MEMORY || status == CHOLMOD_TOO_LARGE)
          throw std::bad_alloc();
        if (status == CHOLMOD_NOT_POSDEF)
          throw ComputationError("the effective stiffness matrix is not "
                                 "positive definite");
        if (status != CHOLMOD_OK)
          throw ComputationError(fmt::format(
            "CHOLMOD fails for the effective stiffness matrix of {} unknowns "
            "(status {})",
            n_unknowns,
            status));
      }

      bool is_analyzed = false;
      Eigen::CholmodDecomposition<Eigen::SparseMatrix<double>, Eigen::Upper>
        cholesky;
    };



    /// KLU of Trilinos' Amesos.
    class KluSolver : public LinearSolver
    {
    public:
      using LinearSolver::LinearSolver;

    private:
      void
      factorize_matrix(Epetra_CrsMatrix &matrix) override
      {
        problem.SetOperator(&matrix);
        solver.reset(Amesos().Create("Amesos_Klu", problem));
        if (solver == nullptr || solver->SymbolicFactorization() != 0 ||
            solver->NumericFactorization() != 0)
          throw ComputationError(
            "KLU cannot factorize the effective stiffness matrix of " +
            std::to_string(matrix.NumMyRows()) + " unknowns");
      }

      void
      solve_factorized(const Eigen::VectorXd &right_hand_side,
                       Eigen::VectorXd       &x) override
      {
        x.resize(right_hand_side.size());
        const Epetra_Map &map = problem.GetOperator()->OperatorDomainMap();
        Epetra_Vector     b(View,
                        map,
                        const_cast<double *>(right_hand_side.data()));
        Epetra_Vector     solution(View, map, x.data());
        problem.SetRHS(&b);
        problem.SetLHS(&solution);
        if (solver->Solve() != 0)
          throw ComputationError("KLU cannot solve");
      }

      Epetra_LinearProblem               problem;
      std::unique_ptr<Amesos_BaseSolver> solver;
    };
  } // namespace



  std::unique_ptr<LinearSolver>
  make_linear_solver(const SolverType type, PlateWork &work)
  {
    if (type == SolverType::KLU)
      return std::make_unique<KluSolver>(work);
    return std::make_unique<CholmodSolver>(work);
  }
} // namespace PlateImpact
