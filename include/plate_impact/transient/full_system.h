#pragma once

#include "plate_impact/transient/linear_solver.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <memory>
#include <optional>
#include <utility>

namespace PlateImpact
{
  /// All unknowns of a mesh under one load. Loads share the factorization.
  class FullSystem : public SemidiscreteSystem
  {
  public:
    /// @param load  u, as PlateDiscretization::load() returns it
    FullSystem(std::shared_ptr<EffectiveStiffness> matrices,
               const Eigen::VectorXd              &load)
      : SemidiscreteSystem(load,
                           matrices->damping,
                           !matrices->discretization.is_nonlinear())
      , matrices(std::move(matrices))
    {}

    void
    multiply_stiffness(const Eigen::VectorXd &x,
                       Eigen::VectorXd       &y) const override
    {
      y.noalias() = as_eigen(matrices->discretization.stiffness()) * x;
    }

    void
    multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const override
    {
      y.noalias() = as_eigen(matrices->discretization.mass()) * x;
    }

    void
    solve(const double c, const Eigen::VectorXd &b, Eigen::VectorXd &x) override
    {
      matrices->solve(c, b, x);
    }

    /// Infinite where K, which is factorized for it, cannot be inverted. A
    /// bound for large deflections, too: they stretch the plate, which stiffens
    /// it.
    double
    static_compliance() override;

    std::unique_ptr<PlateMotion>
    motion(const NewmarkScheme &scheme) override;

    const std::shared_ptr<EffectiveStiffness> matrices;

  private:
    std::optional<double> compliance; ///< under u [m/N]
  };
} // namespace PlateImpact
