#pragma once

#include <Eigen/Core>

#include <optional>

namespace PlateImpact
{
  /// The plate's side of a transient, from rest: steps of Newmark's method
  /// under forces at their beginning and end. What a step depends on the force
  /// at its end is linear, or made so again until the step is in equilibrium.
  class PlateMotion
  {
  public:
    virtual ~PlateMotion() = default;

    /// Begins a step.
    /// @param begin_force  at its beginning [N]
    /// @return displacement under the load at its end without further force [m]
    virtual double
    begin_step(double begin_force) = 0;

    /// Displacement under the load at the end of a step for a unit force
    /// there. [m/N]
    double
    unit_displacement() const
    {
      return w_of_unit_response;
    }

    /// Ends the step.
    /// @param at_begin  further force at its beginning [N]
    /// @param at_end    force at its end [N]
    /// @return nothing; or, as begin_step(), a displacement of the plate
    ///         linearized about where it is now, if that is no equilibrium: the
    ///         step has to be ended again
    /// @throws ComputationError when equilibrium is not found
    virtual std::optional<double>
    end_step(double at_begin, double at_end) = 0;

    /// Under the load. [m]
    double
    displacement() const
    {
      return w;
    }

    /// [J]
    virtual double
    energy() const
    {
      return 0.5 * (v.dot(Mv) + z.dot(Kz));
    }

    /// By damping, so far; exact where the scheme conserves energy. [J]
    double
    dissipated_energy() const
    {
      return dissipated;
    }

    /// z, the unknowns of the plate.
    const Eigen::VectorXd &
    unknowns() const
    {
      return z;
    }

  protected:
    Eigen::VectorXd z, v, Kz, Mv; ///< v: rates of z
    Eigen::VectorXd increment;    ///< of z in the step
    Eigen::VectorXd unit_response;
    double          w = 0., w_of_unit_response = 0., dissipated = 0.;
  };
} // namespace PlateImpact
