#ifndef plate_impact_time_stepper_h
#define plate_impact_time_stepper_h

#include "plate_impact/contact_history.h"
#include "plate_impact/contact_law.h"
#include "plate_impact/contact_solver.h"
#include "plate_impact/impactor.h"
#include "plate_impact/parameters.h"
#include "plate_impact/semidiscrete_plate.h"

#include <Eigen/Core>

#include <optional>

namespace PlateImpact
{
  /// Integrates plate and impactor in time: Newmark's method for both and one
  /// scalar contact equation per step (eqs. 19-31 of the paper).
  ///
  /// A step advances by the increment d of the displacements, which keeps
  /// digits that the paper's total form loses on small steps:
  ///   K* d = f_1 u + c_2 f_0 u - (1 + c_2) K z + c_1 M v,   K* = K + c_0 M,
  /// c_0 = 1/(beta dt^2), c_1 = 1/(beta dt), c_2 = 1/(2 beta) - 1. The free
  /// displacement is its solution for the part of the forces that is known, the
  /// unit response z_u = K*^-1 u belongs to the unknown force phi; what the
  /// contact sees of both is a number each. The vectors K z and M v follow from
  /// the solution of the step itself, so that a step costs one solve, one
  /// product with K, and the energies nothing but scalar products.
  ///
  /// Without a force the average-acceleration scheme keeps the plate's energy
  /// E, and the displacement under the load never leaves +-sqrt(2 E c), c the
  /// static compliance. An impactor that is beyond and flies away has left for
  /// good.
  class TimeStepper
  {
  public:
    /// Factorizes the effective stiffness and computes the unit response.
    /// Plate, law and integration must outlive the stepper.
    TimeStepper(const TimeParameters     &time,
                SemidiscretePlate        &plate,
                const ContactLaw         &law,
                const ContactIntegration &integration,
                const Impactor           &impactor);

    /// Steps that it takes to the end time.
    unsigned int
    n_steps() const;

    /// One step.
    /// @throws ComputationError naming step and quantity when a value is not
    ///         finite or the contact equation is not solved
    void
    advance();

    const ContactState &
    state() const;

    /// z, the unknowns of the plate.
    const Eigen::VectorXd &
    displacement() const;

    /// Change of the impactor's momentum so far. [N s]
    double
    impulse() const;

    /// Time since when no further contact is possible; empty as long as one is,
    /// or where that is not known. [s]
    std::optional<double>
    separation_time() const;

    /// Solves with the effective stiffness so far.
    unsigned int
    n_linear_solves() const;

    /// Steps in which the contact equation had a solution other than no force.
    unsigned int
    n_contact_steps() const;

  private:
    /// The unknown force phi of the step for the increment without it.
    /// @param known  force at the beginning that does not depend on its end
    double
    contact_force(double known) const;
    void
    move_plate(double end_force);
    void
    move_impactor(double begin_force, double end_force);
    void
    update_state();
    /// Whether the plate can never reach the impactor again.
    bool
    is_out_of_reach() const;

    SemidiscretePlate        &plate;
    const ContactLaw         &law;
    const ContactIntegration &integration;
    const double              beta, gamma;
    const unsigned int        steps;
    const double              dt, c0, c1, c2;

    Impactor              impactor;
    ContactState          current;
    unsigned int          step          = 0;
    double                total_impulse = 0.;
    std::optional<double> separated_at;
    unsigned int          n_solves   = 0;
    unsigned int          n_contacts = 0;

    /// z, v, a and what follows from them; a is needed unless gamma = 2 beta
    Eigen::VectorXd z, v, a, Kz, Mv, Ma;
    Eigen::VectorXd unit_response, right_hand_side, increment, K_increment;
    double          unit_displacement = 0.;
  };
} // namespace PlateImpact

#endif
