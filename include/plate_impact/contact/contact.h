#pragma once

#include "plate_impact/base/choices.h"
#include "plate_impact/contact/contact_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace PlateImpact
{
  /// The contact of impactor and plate at the end of a step: the law of the two
  /// bodies, what gives way in series, and the memory of earlier indentations.
  /// A value: who follows a contact through a transient has a copy.
  ///
  /// **Series.** The approach of the impactor's centre to the plate's
  /// midsurface is delta = alpha + C F(alpha), alpha the indentation. C is
  /// negative where plate and ball are stiffer than the half-spaces of the law
  /// (LayerResponse, ball_compliance()): the approach has a largest value where
  /// C F' = -1, and from C F' = -0.9 on, where the contact is about as wide as
  /// the plate is thick, the force goes on along its tangent. Energies are
  /// those of the approach.
  ///
  /// **Memory.** With an Unloading the law is the curve of first loading. Below
  /// the largest indentation the contact unloads to its dent. Unloading begins
  /// where loading or reloading has ended, and its curve is run both ways while
  /// the bodies touch; only after they have parted the curve of reloading is
  /// run. Within a step the force is one function of the indentation,
  /// continuous and never decreasing. What unloading gives back is stored,
  /// F (alpha - alpha_0) / (n + 1); the rest of the work is dissipated.
  class Contact
  {
  public:
    /// @param law         of first loading
    /// @param compliance  C, in series [m/N]
    /// @param unloading   null: along the law
    explicit Contact(std::shared_ptr<const ContactLaw> law,
                     double                            compliance = 0.,
                     std::shared_ptr<const Unloading>  unloading  = nullptr);

    /// [N]
    double
    force(const double indentation) const
    {
      const auto &[branch, argument] = followed(indentation);
      return branch.force(argument);
    }

    /// Derivative of the force with respect to the indentation. [N/m]
    double
    stiffness(const double indentation) const
    {
      const auto &[branch, argument] = followed(indentation);
      return branch.stiffness(argument);
    }

    /// Mean of the force over the approach between two indentations, without
    /// cancellation: times the change of the approach the work. [N]
    double
    mean_force(double a, double b) const;

    /// delta. [m]
    double
    approach(const double indentation) const
    {
      return indentation + compliance * force(indentation);
    }

    /// d delta / d alpha, above 0.
    double
    approach_derivative(const double indentation) const
    {
      return 1. + compliance * stiffness(indentation);
    }

    /// Indentation under an approach. [m]
    double
    indentation_under(double approach) const;

    /// What the contact gives back from an indentation on. [J]
    double
    stored_energy(const double indentation) const
    {
      const double F         = force(indentation);
      const double in_series = 0.5 * compliance * F * F;
      if (unloading == nullptr)
        return law->potential(indentation) + in_series;
      const double largest = std::max(indentation, reload.end);
      return F == 0. ? 0. :
                       F * (indentation - unloading->dent(largest)) /
            (unloading->power(largest) + 1.) +
          in_series;
    }

    /// What it has dissipated when it reaches an indentation. [J]
    double
    dissipated_energy(const double indentation) const
    {
      if (unloading == nullptr)
        return 0.;
      const double work = mean_force(last, indentation) *
        (approach(indentation) - approach(last));
      return dissipated + work -
        (stored_energy(indentation) - stored_energy(last));
    }

    /// alpha_0, up to which the bodies no longer touch. [m]
    double
    dent() const
    {
      return reload.dent;
    }

    /// A step has ended at an indentation.
    void
    follow(double indentation);

    /// Force up to which the series holds; infinite unless C is negative. [N]
    double largest_force = std::numeric_limits<double>::infinity();

    /// The same, before first touch, with more that gives way in series.
    /// @param more  [m/N]
    Contact
    in_series(double more) const
    {
      return Contact(law, compliance + more, unloading);
    }

    /// The law without memory and series.
    const ContactLaw &
    first_loading() const
    {
      return *law;
    }

  private:
    /// What the force follows at an indentation, unloading, reloading or the
    /// law; and its argument there, less the dent of a curve.
    std::pair<const ContactLaw &, double>
    followed(const double indentation) const
    {
      for (const UnloadingCurve *curve : {&unload, &reload})
        if (indentation <= curve->end)
          return {*curve, indentation - curve->dent};
      return {*law, indentation};
    }

    std::shared_ptr<const ContactLaw> law;
    std::shared_ptr<const Unloading>  unloading;
    double                            compliance;

    UnloadingCurve unload, reload; ///< below the largest indentation
    double         last = 0., dissipated = 0.; ///< where the last step ended
  };


  /// The unknown contact force phi of a time step. By collocation it is that of
  /// the law at the end of the step and acts there (eqs. 28-31 of the paper);
  /// at the beginning acts the force of the step before. Gains energy when the
  /// contact is stiff for the step.
  ///
  /// The integration that conserves energy has the mean force of the law over
  /// the indentations of the step, at both ends. Under average acceleration,
  /// the midpoint rule of a linear plate, its work is the change of the contact
  /// potential: energy is conserved to round-off.
  class ContactIntegration
  {
  public:
    ContactIntegration(const ForceIntegration choice)
      : acts_at_begin(choice == ForceIntegration::energy_conserving)
    {}

    /// The unknown force for the indentations [m] at both ends of the step. [N]
    double
    force(const Contact &contact, const double begin, const double end) const
    {
      return acts_at_begin ? contact.mean_force(begin, end) :
                             contact.force(end);
    }

    /// Its derivative with respect to the indentation at the end. [N/m]
    /// @param force  for these indentations [N]
    double
    stiffness(const Contact &contact,
              const double   begin,
              const double   end,
              const double   force) const
    {
      if (!acts_at_begin)
        return contact.stiffness(end);
      // The quotient is exact but cancels for close indentations; there half
      // the stiffness in the middle is its limit.
      const double distance = end - begin;
      if (std::abs(distance) < 1e-4 * (std::abs(begin) + std::abs(end)))
        return 0.5 * contact.stiffness(0.5 * (begin + end));
      return std::max(0.,
                      (contact.force(end) - force) *
                        contact.approach_derivative(end) /
                        (contact.approach(end) - contact.approach(begin)));
    }

    /// Whether phi acts at the beginning of the step as well, in place of the
    /// law's force there.
    bool acts_at_begin;
  };


  /// Solves the contact equation of a step, delta(alpha) + C phi(alpha) =
  /// delta_free, delta the approach. The left side increases strictly with the
  /// indentation alpha at the end: Newton's method within a bracket always
  /// finds the root. (For the force, as in eq. 31 of the paper, negative
  /// numbers would be raised to the power 3/2.)
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
