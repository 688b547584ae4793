#ifndef plate_impact_contact_contact_solver_h
#define plate_impact_contact_contact_solver_h

#include "plate_impact/base/choices.h"
#include "plate_impact/contact/contact.h"

#include <memory>

namespace PlateImpact
{
  /// How the contact force acts within a time step, as the forces that
  /// Newmark's formulas take at its beginning and at its end. One part of them
  /// is known when the step begins (`known_begin_force`), the other is the
  /// unknown phi of the step, which acts at the end and, where `acts_at_begin`,
  /// at the beginning as well.
  class ContactIntegration
  {
  public:
    virtual ~ContactIntegration() = default;

    /// Force at the beginning of the step that does not depend on its end, for
    /// the law's force there. [N]
    virtual double
    known_begin_force(double force_at_begin) const = 0;

    virtual bool
    acts_at_begin() const = 0;

    /// The unknown force for the indentations [m] at both ends of the step. [N]
    virtual double
    force(const Contact &contact, double begin, double end) const = 0;

    /// Its derivative with respect to the indentation at the end. [N/m]
    /// @param force  for these indentations [N]
    virtual double
    stiffness(const Contact &contact,
              double         begin,
              double         end,
              double         force) const = 0;
  };

  /// The force of the law at the end of the step, as in eqs. 28-31 of the
  /// paper. Gains energy when the contact is stiff for the step.
  class CollocatedContact : public ContactIntegration
  {
  public:
    double
    known_begin_force(double force_at_begin) const override;
    bool
    acts_at_begin() const override;
    double
    force(const Contact &contact, double begin, double end) const override;
    double
    stiffness(const Contact &contact,
              double         begin,
              double         end,
              double         force) const override;
  };

  /// The mean force of the law over the indentations of the step, constant over
  /// the step. With the average-acceleration scheme (beta = 1/4, gamma = 1/2),
  /// which is the midpoint rule for the linear plate, the work of this force is
  /// the change of the contact potential: energy is conserved to round-off.
  class EnergyConservingContact : public ContactIntegration
  {
  public:
    double
    known_begin_force(double force_at_begin) const override;
    bool
    acts_at_begin() const override;
    double
    force(const Contact &contact, double begin, double end) const override;
    double
    stiffness(const Contact &contact,
              double         begin,
              double         end,
              double         force) const override;
  };

  /// The integration that the scene names: `collocation` or `energy
  /// conserving`.
  std::unique_ptr<const ContactIntegration>
  make_contact_integration(ForceIntegration integration);


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

#endif
