#ifndef plate_impact_transient_semidiscrete_system_h
#define plate_impact_transient_semidiscrete_system_h

#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/transient/linear_solver.h"

#include <Eigen/Core>
#include <Epetra_CrsMatrix.h>

#include <limits>
#include <memory>

namespace PlateImpact
{
  /// The plate as the time stepper sees it, M z'' + K z = f u: a stiffness, one
  /// shape u of the load, and solves with K + c M. The same for the unknowns of
  /// a mesh and for a reduced basis.
  class SemidiscreteSystem
  {
  public:
    virtual ~SemidiscreteSystem() = default;

    /// u, the forces conjugate to the unknowns for a unit contact force.
    virtual const Eigen::VectorXd &
    load() const = 0;

    /// y = K x.
    virtual void
    multiply_stiffness(const Eigen::VectorXd &x, Eigen::VectorXd &y) const = 0;

    /// Factorizes K + c M, eq. 6 with c = 1/(beta dt^2) [1/s^2].
    virtual void
    factorize(double c) = 0;

    /// Solves (K + c M) x = b.
    virtual void
    solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) = 0;

    /// u^T K^-1 u, the displacement under a constant unit force, or any bound
    /// above it; infinite where it costs more to know than knowing it saves,
    /// and for a plate that is free to move. [m/N]
    virtual double
    static_compliance() const
    {
      return std::numeric_limits<double>::infinity();
    }
  };


  /// All unknowns of a mesh.
  class FullSystem : public SemidiscreteSystem
  {
  public:
    /// @param model   assembled; must outlive this object
    /// @param load    u, as PlateDiscretization::load() returns it
    FullSystem(const PlateDiscretization    &model,
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

    /// As PlateDiscretization::is_free().
    bool
    is_free() const;

    unsigned int
    n_factorizations() const;

    /// Wall time of all factorizations. [s]
    double
    factorization_seconds() const;

    /// As LinearSolver::factor_size(). [bytes]
    double
    factor_size() const;

    /// y = M x.
    void
    multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

    /// y = (K + c M) x, with c of the last factorization.
    void
    multiply_effective_stiffness(const Eigen::VectorXd &x,
                                 Eigen::VectorXd       &y) const;

  private:
    const PlateDiscretization        &model;
    Eigen::VectorXd                   u;
    std::unique_ptr<Epetra_CrsMatrix> effective_stiffness;
    std::unique_ptr<LinearSolver>     solver;
    double       factorized_for = -1.; ///< c of the last factorization
    unsigned int factorizations = 0;
    double       seconds        = 0.; ///< of the factorizations
  };
} // namespace PlateImpact

#endif
