#ifndef plate_impact_transient_full_system_h
#define plate_impact_transient_full_system_h

#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/linear_solver.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Epetra_CrsMatrix.h>

#include <memory>
#include <optional>

namespace PlateImpact
{
  /// K + c M of a mesh, factorized for one c after another.
  class EffectiveStiffness
  {
  public:
    /// @param discretization  assembled; must outlive this object
    EffectiveStiffness(const PlateDiscretization &discretization,
                       SolverType                 solver)
      : discretization(discretization)
      , solver(make_linear_solver(solver))
    {}

    /// Does nothing when the last factorization was for the same c.
    void
    factorize(double c);

    /// (K + c M) x = b.
    void
    solve(double c, const Eigen::VectorXd &b, Eigen::VectorXd &x);

    /// y = (K + c M) x.
    void
    multiply(double c, const Eigen::VectorXd &x, Eigen::VectorXd &y);

    /// What was done so far.
    struct Work
    {
      unsigned int factorizations = 0, linear_solves = 0;
      double       factorization_seconds = 0.; ///< wall time [s]
    };

    const Work &
    work() const
    {
      return done;
    }

    const PlateDiscretization &discretization;

    double damping = 0.; ///< as SemidiscreteSystem::damping() [s]

  private:
    std::unique_ptr<Epetra_CrsMatrix>   sum;
    const std::unique_ptr<LinearSolver> solver;
    std::optional<double>               factorized_for; ///< c [1/s^2]
    Work                                done;
  };


  /// All unknowns of a mesh under one load. Loads share the factorization; one
  /// that another has replaced is made again when it is needed.
  class FullSystem : public SemidiscreteSystem
  {
  public:
    /// @param load  u, as PlateDiscretization::load() returns it
    FullSystem(std::shared_ptr<EffectiveStiffness> matrices,
               const Eigen::VectorXd              &load);

    const Eigen::VectorXd &
    load() const override
    {
      return u;
    }

    void
    multiply_stiffness(const Eigen::VectorXd &x,
                       Eigen::VectorXd       &y) const override;
    void
    solve(double c, const Eigen::VectorXd &b, Eigen::VectorXd &x) override;
    double
    damping() const override
    {
      return matrices->damping;
    }

    /// Factorizes K when it is first asked for.
    double
    static_compliance() override;

    EffectiveStiffness &
    effective_stiffness() const
    {
      return *matrices;
    }

  private:
    /// u^T K^-1 u; infinite where K cannot be inverted.
    double
    computed_compliance();

    const std::shared_ptr<EffectiveStiffness> matrices;
    const Eigen::VectorXd                     u;
    std::optional<double>                     compliance; ///< under u [m/N]
  };
} // namespace PlateImpact

#endif
