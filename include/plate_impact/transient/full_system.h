#ifndef plate_impact_transient_full_system_h
#define plate_impact_transient_full_system_h

#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/linear_solver.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>
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
    EffectiveStiffness(const PlateDiscretization    &discretization,
                       std::unique_ptr<LinearSolver> solver);

    /// Does nothing when the last factorization was for the same c.
    void
    factorize(double c);

    /// (K + c M) x = b, with the last c.
    void
    solve(const Eigen::VectorXd &b, Eigen::VectorXd &x);

    const Epetra_CrsMatrix &
    matrix() const;

    unsigned int
    n_factorizations() const;

    unsigned int
    n_solves() const;

    /// Wall time of all factorizations. [s]
    double
    factorization_seconds() const;

    const PlateDiscretization &discretization;

  private:
    std::unique_ptr<Epetra_CrsMatrix>   sum;
    const std::unique_ptr<LinearSolver> solver;
    std::optional<double>               factorized_for; ///< c [1/s^2]
    unsigned int                        factorizations = 0, solves = 0;
    double                              seconds = 0.;
  };


  /// All unknowns of a mesh under one load. Loads share the factorization; one
  /// that another has replaced is made again when it is needed.
  class FullSystem : public SemidiscreteSystem
  {
  public:
    /// @param discretization  assembled; must outlive this object
    /// @param load            u, as PlateDiscretization::load() returns it
    FullSystem(const PlateDiscretization    &discretization,
               const Eigen::VectorXd        &load,
               std::unique_ptr<LinearSolver> solver);

    FullSystem(std::shared_ptr<EffectiveStiffness> effective_stiffness,
               const Eigen::VectorXd              &load);

    const Eigen::VectorXd &
    load() const override;

    void
    multiply_stiffness(const Eigen::VectorXd &x,
                       Eigen::VectorXd       &y) const override;
    void
    factorize(double c) override;
    void
    solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override;
    /// Factorizes K when it is first asked for.
    double
    static_compliance() override;

    /// As PlateDiscretization::is_free().
    bool
    is_free() const;

    /// y = M x.
    void
    multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

    /// y = (K + c M) x.
    void
    multiply_effective_stiffness(const Eigen::VectorXd &x, Eigen::VectorXd &y);

  private:
    /// u^T K^-1 u; infinite where K cannot be inverted.
    double
    computed_compliance();

    const std::shared_ptr<EffectiveStiffness> effective_stiffness;
    const Eigen::VectorXd                     u;
    double                                    c = 0.;     ///< [1/s^2]
    std::optional<double>                     compliance; ///< under u [m/N]
  };
} // namespace PlateImpact

#endif
