#pragma once

#include "plate_impact/transient/newmark_scheme.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <functional>

namespace PlateImpact
{
  /// The motion of a linear plate. A damping b K adds g b K, g =
  /// gamma/(beta dt), to the matrix of a step, which stays K + c M up to a
  /// factor. The free displacement of a step is that for the part of the forces
  /// that does not depend on the step's end; the unit response z_u = K*^-1 u
  /// belongs to the rest. The vectors K z and M v follow from the solution of
  /// the step itself, so that a step costs one solve, one product with K, and
  /// the energies nothing but scalar products.
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
