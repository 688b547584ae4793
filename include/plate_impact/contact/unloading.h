#pragma once

#include "plate_impact/contact/contact_law.h"

#include <cmath>
#include <functional>
#include <memory>

namespace PlateImpact
{
  /// How a contact unloads to a dent alpha_0 from the largest indentation so
  /// far, by functions of that:
  ///   F = F_m ((alpha - alpha_0) / (alpha_m - alpha_0))^n.
  struct Unloading
  {
    /// alpha_0; 0 as long as the contact is elastic. [m]
    std::function<double(double)> dent;

    std::function<double(double)> power; ///< n

    std::function<double(double)> reloading_power; ///< once they have parted
  };


  /// Such a curve as a law of the overlap alpha - alpha_0, up to its end.
  class UnloadingCurve : public ContactLaw
  {
  public:
    UnloadingCurve(const double dent      = 0.,
                   const double end       = 0.,
                   const double end_force = 0.,
                   const double power     = 1.)
      : dent(dent)
      , end(end)
      , end_force(end_force)
      , power(power)
    {}

    double dent, end; ///< indentations [m]
    double end_force, power;

    double
    force(const double overlap) const override
    {
      return overlap > 0. ?
        end_force * std::pow(overlap / (end - dent), power) :
        0.;
    }

    double
    stiffness(const double overlap) const override
    {
      return overlap > 0. ? power * force(overlap) / overlap : 0.;
    }

    double
    potential(const double overlap) const override
    {
      return overlap * force(overlap) / (power + 1.);
    }
  };


  /// What Yang & Sun measured on laminates (NASA CR-165460, 1981; Tan & Sun, J.
  /// Appl. Mech. 52, 1985, p. 6): beyond a critical indentation alpha_cr the
  /// contact leaves a dent alpha_0 = alpha_m (1 - (alpha_cr / alpha_m)^0.4). It
  /// unloads with the power 2.5 and reloads with 1.5.
  /// @param critical  alpha_cr [m]
  inline std::shared_ptr<const Unloading>
  yang_sun_unloading(const double critical)
  {
    const auto dent = [critical](const double largest) {
      return largest > critical ?
        largest * (1. - std::pow(critical / largest, 0.4)) :
        0.;
    };
    return std::make_shared<Unloading>(
      Unloading{dent, [](double) { return 2.5; }, [](double) { return 1.5; }});
  }
} // namespace PlateImpact
