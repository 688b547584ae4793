#pragma once

#include "plate_impact/contact/contact_law.h"

namespace PlateImpact
{
  /// A cylinder of radius r that touches a half-space along the length 2l (eq.
  /// 32 of the paper, Johnson, Contact Mechanics, sec. 5.3):
  ///   alpha = F / (pi l E*) (1.886 + ln(l/a)),  a = sqrt(4 (F/2l) r / (pi
  ///   E*)),
  /// or another constant in place of 1.886.
  /// The paper prints a with the total force F in place of the force per
  /// length, and inverts to a power 3/2 (eq. 33); up to the logarithm the law
  /// is linear.
  ///
  /// The inverse is Lambert's function W_{-1}. The law loses its meaning when
  /// the contact is as wide as long, a = l, and would turn back where the
  /// logarithm with its constant is 1/2: from a = l on, or from 1, it is
  /// continued by its tangent.
  class LineLaw : public ContactLaw
  {
  public:
    /// Johnson's.
    static constexpr double constant_of_half_space = 1.886;

    /// @param half_length  l [m]
    /// @param modulus      E* [Pa]
    /// @param constant     beside ln(l/a)
    LineLaw(double radius,
            double half_length,
            double modulus,
            double constant = constant_of_half_space);

    double
    force(double indentation) const override;
    double
    stiffness(double indentation) const override;
    double
    potential(double indentation) const override;

  private:
    /// constant + ln(l/a) at a force.
    double
    logarithm(double force) const;

    const double constant;
    const double compliance;          ///< 1 / (pi l E*) [m/N]
    const double force_scale;         ///< force at which a = l [N]
    const double least_logarithm;     ///< where the tangent begins
    const double tangent_force;       ///< there [N]
    const double largest_indentation; ///< there [m]
  };
} // namespace PlateImpact
