#ifndef plate_impact_transient_plate_stepper_h
#define plate_impact_transient_plate_stepper_h

#include "plate_impact/contact/contact_solver.h"
#include "plate_impact/transient/newmark_scheme.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

#include <functional>

namespace PlateImpact
{
  /// The plate's side of a transient, from rest: steps of Newmark's method
  /// under forces at their beginning and end. A damping b K adds g b K, g =
  /// gamma/(beta dt), to the matrix of a step, which stays K + c M up to a
  /// factor. The free displacement of a step
  /// is that for the part of the forces that does not depend on the step's end;
  /// the unit response z_u = K*^-1 u belongs to the rest. The vectors K z and M
  /// v follow from the solution of the step itself, so that a step costs one
  /// solve, one product with K, and the energies nothing but scalar products.
  class PlateStepper
  {
  public:
    /// Computes the unit response.
    /// @param plate  must outlive the stepper
    PlateStepper(const NewmarkScheme &scheme, SemidiscreteSystem &plate);

    /// Begins a step.
    /// @param begin_force  at its beginning [N]
    /// @return displacement under the load at its end without further force [m]
    double
    begin_step(double begin_force);

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
    void
    end_step(double at_begin, double at_end);

    /// Under the load. [m]
    double
    displacement() const
    {
      return w;
    }

    /// [J]
    double
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
    double              w = 0., dissipated = 0.;

    /// z, v, a and what follows from them; a is needed unless gamma = 2 beta,
    /// K v and K a with damping unless the scheme conserves energy
    Eigen::VectorXd z, v, a, Kz, Kv, Ka, Mv, Ma;
    Eigen::VectorXd unit_response, right_hand_side, increment, K_increment;
    double          w_of_unit_response = 0.;
  };


  /// Steps a plate from rest under contact forces that are known.
  /// @param forces  phi of every step [N]
  /// @param show    called after every step, counted from 1
  void
  step_under(
    const Eigen::VectorXd                                         &forces,
    const NewmarkScheme                                           &scheme,
    const ContactIntegration                                      &integration,
    SemidiscreteSystem                                            &plate,
    const std::function<void(Eigen::Index, const PlateStepper &)> &show);
} // namespace PlateImpact

#endif
