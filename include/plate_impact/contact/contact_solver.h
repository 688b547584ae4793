#pragma once

#include "plate_impact/base/choices.h"
#include "plate_impact/contact/contact.h"

namespace PlateImpact
{
  /// How the contact force acts within a time step, as the forces that
  /// Newmark's formulas take at its beginning and at its end. One part of them
  /// is known when the step begins (`known_begin_force`), the other is the
  /// unknown phi of the step, which acts at the end and, where `acts_at_begin`,
  /// at the beginning as well.
  ///
  /// By collocation phi is the force of the law at the end of the step, as in
  /// eqs. 28-31 of the paper. Gains energy when the contact is stiff for the
  /// step.
  ///
  /// The integration that conserves energy has the mean force of the law over
  /// the indentations of the step, constant over the step. With the
  /// average-acceleration scheme (beta = 1/4, gamma = 1/2), which is the
  /// midpoint rule for the linear plate, the work of this force is the change
  /// of the contact potential: energy is conserved to round-off.
  class ContactIntegration
  {
  public:
    ContactIntegration(const ForceIntegration choice)
      : is_mean(choice == ForceIntegration::energy_conserving)
    {}

    /// Force at the beginning of the step that does not depend on its end, for
    /// the law's force there. [N]
    double
    known_begin_force(const double force_at_begin) const
    {
      return is_mean ? 0. : force_at_begin;
    }

    bool
    acts_at_begin() const
    {
      return is_mean;
    }

    /// The unknown force for the indentations [m] at both ends of the step. [N]
    double
    force(const Contact &contact, const double begin, const double end) const
    {
      return is_mean ? contact.mean_force(begin, end) : contact.force(end);
    }

    /// Its derivative with respect to the indentation at the end. [N/m]
    /// @param force  for these indentations [N]
    double
    stiffness(const Contact &contact,
              double         begin,
              double         end,
              double         force) const;

  private:
    bool is_mean;
  };


  /// Solves the scalar contact equation of a step, delta(alpha) + C phi(alpha)
  /// = delta_free, for the indentation alpha at its end, and returns the force
  /// phi. delta is the approach that belongs to alpha. phi never decreases with
  /// alpha, so that the left side increases strictly: Newton's method within a
  /// bracket always finds the one root. Solving for the indentation and not, as
  /// eq. 31 of the paper, for the force never raises a negative number to the
  /// power 3/2.
  ///
  /// @param begin       indentation at the beginning of the step [m]
  /// @param free        approach at its end without the force phi [m]
  /// @param compliance  C, approach lost per unit of phi [m/N], not negative
  /// @return phi [N], exactly 0 where there is no contact within the step
  /// @throws ComputationError when an argument is not finite
  double
  solve_contact(const ContactIntegration &integration,
                const Contact            &contact,
                double                    begin,
                double                    free,
                double                    compliance);
} // namespace PlateImpact
