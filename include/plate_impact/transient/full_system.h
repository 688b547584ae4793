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
  /// All unknowns of a mesh.
  class FullSystem : public SemidiscreteSystem
  {
  public:
    /// @param discretization  assembled; must outlive this object
    /// @param load            u, as PlateDiscretization::load() returns it
    FullSystem(const PlateDiscretization    &discretization,
               const Eigen::VectorXd        &load,
               std::unique_ptr<LinearSolver> solver);

    const Eigen::VectorXd &
    load() const override;

    /// Replaces the load; the factorization stays.
    void
    set_load(const Eigen::VectorXd &load);

    void
    multiply_stiffness(const Eigen::VectorXd &x,
                       Eigen::VectorXd       &y) const override;
    /// Does nothing when the last factorization was for the same c.
    void
    factorize(double c) override;
    void
    solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override;
    /// Factorizes K when it is first asked for, and what was factorized before
    /// once more.
    double
    static_compliance() override;

    /// As PlateDiscretization::is_free().
    bool
    is_free() const;

    unsigned int
    n_factorizations() const;

    /// Solves so far, whoever asked for them.
    unsigned int
    n_solves() const;

    /// Wall time of all factorizations. [s]
    double
    factorization_seconds() const;

    /// y = M x.
    void
    multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

    /// y = (K + c M) x, with c of the last factorization.
    void
    multiply_effective_stiffness(const Eigen::VectorXd &x,
                                 Eigen::VectorXd       &y) const;

  private:
    /// u^T K^-1 u; infinite where K cannot be inverted.
    double
    computed_compliance();

    const PlateDiscretization        &discretization;
    Eigen::VectorXd                   u;
    std::unique_ptr<Epetra_CrsMatrix> effective_stiffness;
    std::unique_ptr<LinearSolver>     solver;
    std::optional<double>             factorized_for; ///< c [1/s^2]
    std::optional<double>             compliance;     ///< under u [m/N]
    unsigned int                      factorizations = 0, solves = 0;
    double                            seconds = 0.; ///< of the factorizations
  };
} // namespace PlateImpact

#endif
