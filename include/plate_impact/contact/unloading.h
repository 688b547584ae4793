#pragma once

#include <cmath>
#include <functional>
#include <memory>

namespace PlateImpact
{
  /// How a contact unloads that leaves a dent. From the largest indentation so
  /// far alpha_m, where the force was F_m,
  ///   F = F_m ((alpha - alpha_0) / (alpha_m - alpha_0))^n,
  /// with the dent alpha_0 and the power n. All are functions of alpha_m.
  struct Unloading
  {
    /// alpha_0; 0 as long as the contact is elastic. [m]
    std::function<double(double)> dent;

    std::function<double(double)> power; ///< n

    /// n when the bodies touch again after they have parted.
    std::function<double(double)> reloading_power;
  };


  /// That curve, or the one of reloading, from the dent to an end where it has
  /// a length. Within it the functions are those of ContactLaw.
  struct UnloadingCurve
  {
    double dent = 0., end = 0., end_force = 0., power = 1.;

    double
    force(const double indentation) const
    {
      return end_force * std::pow(share(indentation), power);
    }

    double
    stiffness(const double indentation) const
    {
      return power / (end - dent) * end_force *
        std::pow(share(indentation), power - 1.);
    }

    /// @param low,high  in this order
    double
    mean_force(const double low, const double high) const
    {
      return end_force / (power + 1.) *
        difference_quotient(low, high, power + 1.);
    }

    double
    mean_stiffness(const double low, const double high) const
    {
      return end_force / (end - dent) * difference_quotient(low, high, power);
    }

  private:
    double
    share(const double indentation) const
    {
      return (indentation - dent) / (end - dent);
    }

    /// (y^p - x^p) / (y - x) of the shares x and y, without cancellation.
    double
    difference_quotient(const double low,
                        const double high,
                        const double p) const
    {
      const double x = share(low), d = (high - low) / (end - dent);
      return x > 0. ? std::pow(x, p) * std::expm1(p * std::log1p(d / x)) / d :
                      std::pow(d, p - 1.);
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
