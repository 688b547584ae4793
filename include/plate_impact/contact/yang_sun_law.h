#ifndef plate_impact_contact_yang_sun_law_h
#define plate_impact_contact_yang_sun_law_h

#include "plate_impact/contact/contact_law.h"

#include <array>

namespace PlateImpact
{
  /// Hertz's law with the unloading and reloading that Yang & Sun measured on
  /// laminates (NASA CR-165460, 1981; Tan & Sun, J. Appl. Mech. 52, 1985, p.
  /// 6). Beyond a critical indentation alpha_cr the contact leaves a dent
  /// alpha_0. With the largest indentation so far alpha_m, F_m:
  ///   alpha_0 = alpha_m (1 - (alpha_cr / alpha_m)^0.4), or 0 up to alpha_cr,
  ///   unloading  F = F_t ((alpha - alpha_0) / (alpha_t - alpha_0))^2.5,
  ///   reloading  F = F_m ((alpha - alpha_0) / (alpha_m - alpha_0))^1.5,
  ///   loading    F = k alpha^1.5.
  /// Unloading begins where the loading or the reloading before has ended,
  /// (alpha_t, F_t), and is run both ways while the bodies touch; only after
  /// they have parted the whole curve of reloading is run. Within a step the
  /// force is one function of the indentation, continuous and never decreasing.
  ///
  /// What unloading gives back is stored, F (alpha - alpha_0) / 3.5; the rest
  /// of the work is dissipated.
  class YangSunLaw : public ContactLaw
  {
  public:
    /// @param coefficient k [N/m^{3/2}]
    /// @param critical_indentation alpha_cr [m]
    YangSunLaw(double coefficient, double critical_indentation);

    double
    force(double indentation) const override;
    double
    stiffness(double indentation) const override;
    double
    potential(double indentation) const override;
    double
    mean_force(double a, double b) const override;
    double
    indentation(double force) const override;
    double
    stored_energy(double indentation) const override;
    double
    dissipated_energy(double indentation) const override;
    double
    permanent_indentation() const override;
    std::unique_ptr<const ContactLaw>
    after(double indentation) const override;

  private:
    /// F = force ((alpha - origin) / (end - origin))^power.
    struct Branch
    {
      double begin, end; ///< where it holds [m]
      double origin, reach, force, power;

      double
      at(double indentation) const;
      double
      slope(double indentation) const;
      /// Of the force between two indentations, free of cancellation.
      double
      mean(double low, double high) const;
    };

    /// Unloading, reloading and loading; empty ones have no length.
    std::array<Branch, 3>
    branches() const;
    Branch
    branch_at(double indentation) const;

    /// That of the next step, whose energies are not known yet.
    YangSunLaw
    moved_to(double indentation) const;

    double k, critical;
    double largest = 0.; ///< alpha_m
    double dent    = 0.; ///< alpha_0
    double turn    = 0.; ///< alpha_t
    /// Where the last step ended, and what had been dissipated then.
    double last = 0., dissipated = 0.;
    double turn_force = 0.; ///< F_t
  };
} // namespace PlateImpact

#endif
