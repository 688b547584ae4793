#pragma once

#include "plate_impact/transient/newmark_scheme.h"

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

namespace PlateImpact
{
  /// The plate's side of a transient, from rest: steps of Newmark's method
  /// under forces at their beginning and end, linear in that at the end, or
  /// made so again until the step is in equilibrium.
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
    /// @return nothing; or, if the plate is not in equilibrium, as begin_step()
    ///         a displacement, linearized about where it is now: the step has
    ///         to be ended again
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


  /// The plate for the time stepper, M z'' + b K z' + K z = f u, of the
  /// unknowns of a mesh or in a reduced basis.
  class SemidiscreteSystem
  {
  public:
    /// @param load     u, the forces conjugate to the unknowns for a unit
    ///                 contact force
    /// @param damping  b, of a material that answers to strains and their rates
    ///                 (Kelvin and Voigt); 0 without damping [s]
    explicit SemidiscreteSystem(const Eigen::VectorXd &load,
                                const double           damping = 0.)
      : u(load)
      , b(damping)
    {}

    virtual ~SemidiscreteSystem() = default;

    const Eigen::VectorXd &
    load() const
    {
      return u;
    }

    double
    damping() const
    {
      return b;
    }

    /// y = K x.
    virtual void
    multiply_stiffness(const Eigen::VectorXd &x, Eigen::VectorXd &y) const = 0;

    /// Solves (K + c M) x = b, eq. 6 with c = 1/(beta dt^2) [1/s^2]. The
    /// factorization is kept until another c is asked for.
    virtual void
    solve(double c, const Eigen::VectorXd &b, Eigen::VectorXd &x) = 0;

    /// u^T K^-1 u, the displacement under a constant unit force, or any bound
    /// above it; infinite for a plate that is free to move. [m/N]
    virtual double
    static_compliance() = 0;

    /// Whether responses may be added up.
    virtual bool
    is_linear() const
    {
      return true;
    }

    /// From rest, in steps of a scheme; by default a PlateStepper. The system
    /// must outlive it.
    virtual std::unique_ptr<PlateMotion>
    motion(const NewmarkScheme &scheme);

    /// Unknowns of the mesh as vectors times coordinates, the first rows of
    /// states.
    struct Span
    {
      Eigen::Ref<const Eigen::MatrixXd> vectors;
      Eigen::MatrixXd                   coordinates; ///< a column per state
    };

    /// By default every state is a vector of its own.
    /// @param states  must outlive the result, a column each
    virtual Span
    span(const Eigen::Ref<const Eigen::MatrixXd> &states) const
    {
      return {states, Eigen::MatrixXd::Identity(states.cols(), states.cols())};
    }

    /// Those unknowns, a column per state.
    Eigen::MatrixXd
    unknowns(const Eigen::Ref<const Eigen::MatrixXd> &states) const
    {
      const Span in_mesh = span(states);
      return in_mesh.vectors * in_mesh.coordinates;
    }

    /// How many states are best looked at together on the mesh: by default
    /// enough to make matrix products fast, and fewer on large meshes.
    virtual unsigned int
    n_states_at_once() const
    {
      return std::clamp<Eigen::Index>(2400000 / load().size(), 1, 16);
    }

  private:
    const Eigen::VectorXd u;
    const double          b;
  };



  /// The motion of a linear plate. A damping b K adds g b K, g =
  /// gamma/(beta dt), to the matrix of a step, which stays K + c M up to a
  /// factor. K z and M v follow from the solution of the step itself, so that a
  /// step costs one solve, one product with K and scalar products.
  class PlateStepper : public PlateMotion
  {
  public:
    /// Computes the unit response.
    /// @param plate  must outlive the stepper
    PlateStepper(const NewmarkScheme &scheme, SemidiscreteSystem &plate);

    double
    begin_step(double begin_force) override;

    std::optional<double>
    end_step(double at_begin, double at_end) override;

    /// v, their rates.
    const Eigen::VectorXd &
    rates() const
    {
      return v;
    }

  private:
    const NewmarkScheme scheme;
    SemidiscreteSystem &plate;
    const double        damping;    ///< b [s]
    const double        stiffening; ///< 1 + g b

    Eigen::VectorXd a, Kv, Ka, Ma; ///< K v and K a: with damping
    Eigen::VectorXd right_hand_side, K_increment;
  };


  /// Steps a plate from rest under contact forces that are known.
  /// @param forces  phi of every step [N]
  /// @param show    called after every step, counted from 1
  void
  step_under(
    const Eigen::VectorXd                                         &forces,
    const NewmarkScheme                                           &scheme,
    SemidiscreteSystem                                            &plate,
    const std::function<void(Eigen::Index, const PlateStepper &)> &show);
} // namespace PlateImpact
