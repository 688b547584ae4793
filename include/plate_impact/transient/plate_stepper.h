#ifndef plate_impact_transient_plate_stepper_h
#define plate_impact_transient_plate_stepper_h

#include "plate_impact/transient/newmark_scheme.h"
#include "plate_impact/transient/semidiscrete_system.h"

#include <Eigen/Core>

namespace PlateImpact
{
  /// The plate's side of a transient, from rest: steps of Newmark's method
  /// under forces at their beginning and end. The free displacement of a step
  /// is that for the part of the forces that is known; the unit response z_u =
  /// K*^-1 u belongs to the rest. The vectors K z and M v follow from the
  /// solution of the step itself, so that a step costs one solve, one product
  /// with K, and the energies nothing but scalar products.
  class PlateStepper
  {
  public:
    /// Factorizes the effective stiffness and computes the unit response.
    /// @param plate  must outlive the stepper
    PlateStepper(const NewmarkScheme &scheme, SemidiscreteSystem &plate);

    /// Begins a step.
    /// @param known  force at its beginning [N]
    /// @return displacement under the load at its end without further force [m]
    double
    begin_step(double known);

    /// Displacement under the load at the end of a step for a unit force
    /// there. [m/N]
    double
    unit_displacement() const;

    /// Ends the step.
    /// @param at_begin  force at its beginning beyond the known one [N]
    /// @param at_end    force at its end [N]
    void
    end_step(double at_begin, double at_end);

    /// Under the load. [m]
    double
    displacement() const;

    /// [J]
    double
    energy() const;

    /// z, the unknowns of the plate.
    const Eigen::VectorXd &
    unknowns() const;

  private:
    const NewmarkScheme scheme;
    SemidiscreteSystem &plate;
    double              w = 0.;

    /// z, v, a and what follows from them; a is needed unless gamma = 2 beta
    Eigen::VectorXd z, v, a, Kz, Mv, Ma;
    Eigen::VectorXd unit_response, right_hand_side, increment, K_increment;
    double          w_of_unit_response = 0.;
  };
} // namespace PlateImpact

#endif
