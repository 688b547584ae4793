#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace PlateImpact
{
  /// Newmark's method for a transient of equal steps: eqs. 3-7 of the paper in
  /// increments d, which keep digits that the total form loses on small steps,
  ///   K* d = f_1 + c_2 f_0 - (1 + c_2) K z + c_1 M v,   K* = K + c_0 M.
  struct NewmarkScheme
  {
    /// The smallest number of steps, none longer than the scene's.
    NewmarkScheme(const TimeParameters     &time,
                  const ContactIntegration &integration)
      : beta(time.newmark_beta)
      , gamma(time.newmark_gamma)
      , conserves_energy(time.is_average_acceleration())
      , order(gamma == 0.5 ? 2 : 1)
      , integration(integration)
      , n_steps(
          std::max(1., std::ceil(time.end_time / time.time_step * (1 - 1e-9))))
      // the scene's own where the end time is a multiple of it, so that longer
      // transients take the same steps to the last digit
      , dt(std::abs(time.end_time / n_steps - time.time_step) <=
               1e-9 * (time.end_time / n_steps) ?
             time.time_step :
             time.end_time / n_steps)
      , c0(1. / (beta * dt * dt))
      , c1(1. / (beta * dt))
      , c2(1. / (2. * beta) - 1.)
    {}

    const double beta, gamma;

    /// Of a linear system, but for the work of the load: average acceleration.
    const bool conserves_energy;

    /// Of the error in the step: gamma other than 1/2 damps, to first order.
    const unsigned int order;

    const ContactIntegration integration;
    const unsigned int       n_steps;
    const double             dt; ///< [s]
    const double             c0; ///< 1/(beta dt^2) [1/s^2]
    const double             c1; ///< 1/(beta dt) [1/s]
    const double             c2; ///< 1/(2 beta) - 1
  };


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

    /// Ends the step.
    /// @param at_begin  further force at its beginning [N]
    /// @param at_end    force at its end [N]
    /// @return nothing; or, if the plate is not in equilibrium, as begin_step()
    ///         a displacement, linearized about where it is now: the step has
    ///         to be ended again
    /// @throws ComputationError when equilibrium is not found
    virtual std::optional<double>
    end_step(double at_begin, double at_end) = 0;

    /// [J]
    virtual double
    energy() const
    {
      return 0.5 * (v.dot(Mv) + z.dot(Kz));
    }

    Eigen::VectorXd z, v;   ///< the unknowns of the plate, and their rates
    double          w = 0.; ///< displacement under the load [m]

    /// Displacement under the load at the end of a step for a unit force
    /// there. [m/N]
    double w_of_unit_response = 0.;

    /// By damping, so far; exact where the scheme conserves energy. [J]
    double dissipated = 0.;

  protected:
    Eigen::VectorXd Kz, Mv;
    Eigen::VectorXd increment; ///< of z in the step
    Eigen::VectorXd unit_response;
  };


  /// The plate for the time stepper, M z'' + b K z' + K z = f u, of the
  /// unknowns of a mesh or in a reduced basis.
  class SemidiscreteSystem
  {
  public:
    explicit SemidiscreteSystem(const Eigen::VectorXd &load,
                                const double           damping   = 0.,
                                const bool             is_linear = true)
      : load(load)
      , damping(damping)
      , is_linear(is_linear)
    {}

    virtual ~SemidiscreteSystem() = default;

    /// u, the forces conjugate to the unknowns for a unit contact force.
    const Eigen::VectorXd load;

    /// b, of a material that answers to strains and their rates (Kelvin and
    /// Voigt); 0 without damping. [s]
    const double damping;

    const bool is_linear; ///< responses may be added up

    /// y = K x.
    virtual void
    multiply_stiffness(const Eigen::VectorXd &x, Eigen::VectorXd &y) const = 0;

    /// y = M x.
    virtual void
    multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const = 0;

    /// Solves (K + c M) x = b, eq. 6 with c = 1/(beta dt^2) [1/s^2]. The
    /// factorization is kept until another c is asked for.
    virtual void
    solve(double c, const Eigen::VectorXd &b, Eigen::VectorXd &x) = 0;

    /// u^T K^-1 u, the displacement under a constant unit force, or any bound
    /// above it; infinite where none is known, or the plate is free to move.
    /// [m/N]
    virtual double
    static_compliance()
    {
      return std::numeric_limits<double>::infinity();
    }

    /// From rest, in steps of a scheme; by default the motion of a linear
    /// plate. The system must outlive it.
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

    /// The states whose unknowns are combinations of the vectors of a span.
    /// @param coordinates  a row per vector, a column per state
    virtual Eigen::MatrixXd
    states(const Span &span, const Eigen::MatrixXd &coordinates) const
    {
      return span.vectors * coordinates;
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
      return std::clamp<Eigen::Index>(2400000 / load.size(), 1, 16);
    }
  };


  /// Steps a plate from rest under contact forces that are known.
  /// @param forces  phi of every step [N]
  /// @param show    called after every step, counted from 1
  void
  step_under(
    const Eigen::VectorXd                                        &forces,
    const NewmarkScheme                                          &scheme,
    SemidiscreteSystem                                           &plate,
    const std::function<void(Eigen::Index, const PlateMotion &)> &show);
} // namespace PlateImpact
