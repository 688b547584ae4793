#pragma once

#include "plate_impact/contact/contact_law.h"
#include "plate_impact/contact/unloading.h"

#include <limits>
#include <memory>
#include <utility>

namespace PlateImpact
{
  /// The contact of impactor and plate as it stands at the end of a step: the
  /// law of the two bodies, what gives way in series with it, and what it
  /// remembers of earlier indentations. A value: who follows a contact through
  /// a transient has a copy.
  ///
  /// **Series.** The approach of the impactor's centre to the plate's
  /// midsurface beyond first touch is
  ///   delta = alpha + C F(alpha)
  /// with the indentation alpha and the compliance C of all that is not in the
  /// law. C is negative where plate and ball are stiffer than the half-spaces
  /// of the law (LayerResponse, ball_compliance()). The approach then has a
  /// largest value, where C F' = -1; from C F' = -0.9 on, where the contact is
  /// about as wide as the plate is thick, the force is continued by its
  /// tangent. Energies are those of the approach.
  ///
  /// **Memory.** With an Unloading the law is the curve of first loading. Below
  /// the largest indentation alpha_m the contact unloads to its dent. Unloading
  /// begins where the loading or reloading before has ended, and is run both
  /// ways while the bodies touch; only after they have parted the whole curve
  /// of reloading is run. Within a step the force is one function of the
  /// indentation, continuous and never decreasing. What unloading gives back
  /// is stored, F (alpha - alpha_0) / (n + 1); the rest of the work is
  /// dissipated.
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

    /// Mean of the force over the approach between two indentations: this
    /// times the change of the approach is the work of the contact. Does not
    /// cancel when they are close. [N]
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
    stored_energy(double indentation) const;

    /// What it has dissipated when it reaches an indentation. [J]
    double
    dissipated_energy(double indentation) const;

    /// alpha_0, up to which the bodies no longer touch. [m]
    double
    dent() const
    {
      return reload.dent;
    }

    /// A step has ended at an indentation.
    void
    follow(double indentation);

    /// The force up to which the series holds; infinite where C is not
    /// negative. [N]
    double
    largest_force() const
    {
      return force_limit;
    }

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
    /// What the force follows at an indentation: the curve of unloading, that
    /// of reloading or the law; and its argument there, an indentation less the
    /// dent of a curve.
    std::pair<const ContactLaw &, double>
    followed(double indentation) const;

    using Mean = double (ContactLaw::*)(double, double) const;

    /// The mean between two indentations by those of what is followed.
    double
    mean(double a, double b, Mean mean_of) const;

    std::shared_ptr<const ContactLaw> law;
    std::shared_ptr<const Unloading>  unloading;
    double                            compliance;
    double force_limit = std::numeric_limits<double>::infinity(); ///< [N]

    UnloadingCurve unload, reload; ///< below the largest indentation
    double         last = 0., dissipated = 0.; ///< where the last step ended
  };
} // namespace PlateImpact
