#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace PlateImpact
{
  /// Where an increasing function of an indentation is 0. [m]
  double
  zero_of(const std::function<double(double)> &increasing);


  /// Force between two bodies as a function of their indentation, as it grows
  /// for the first time: zero for negative indentations, never decreasing, its
  /// slope never decreasing either, but for the 2 % that it drops where
  /// yielding begins. What gives way in series and what the contact remembers
  /// belong to Contact.
  class ContactLaw
  {
  public:
    virtual ~ContactLaw() = default;

    /// Force at an indentation [m]. [N]
    virtual double
    force(double indentation) const = 0;

    /// Derivative of the force with respect to the indentation. [N/m]
    virtual double
    stiffness(double indentation) const = 0;

    /// Integral of the force over the indentation. [J]
    virtual double
    potential(double indentation) const = 0;

    /// Indentation at which the force is reached; 0 for forces up to 0. [m]
    double
    indentation(const double force) const
    {
      return force <= 0. ? 0. : zero_of([&](const double alpha) {
        return this->force(alpha) / force - 1.;
      });
    }

    /// Mean of the force between two indentations, (U(b) - U(a)) / (b - a) with
    /// U the potential: the discrete gradient of Gonzalez (1996),
    /// doi:10.1007/BF02440162, in one dimension. Does not cancel when a is
    /// close to b. [N]
    virtual double
    mean_force(double a, double b) const;

    /// Mean of the stiffness between two indentations, (F(b) - F(a)) / (b - a),
    /// without cancellation. [N/m]
    virtual double
    mean_stiffness(double a, double b) const;
  };


  /// A law up to an indentation, and its tangent there beyond.
  class TangentBeyond : public ContactLaw
  {
  public:
    TangentBeyond(std::shared_ptr<const ContactLaw> law, const double limit)
      : law(std::move(law))
      , limit(limit)
    {}

    double
    force(const double indentation) const override
    {
      const double beyond = indentation - limit;
      return beyond <= 0. ? law->force(indentation) :
                            law->force(limit) + beyond * law->stiffness(limit);
    }

    double
    stiffness(const double indentation) const override
    {
      return law->stiffness(std::min(indentation, limit));
    }

    double
    potential(const double indentation) const override
    {
      const double beyond = indentation - limit;
      return beyond <= 0. ? law->potential(indentation) :
                            law->potential(limit) +
          0.5 * beyond * (law->force(limit) + force(indentation));
    }

  private:
    const std::shared_ptr<const ContactLaw> law;
    const double                            limit;
  };


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
  struct UnloadingCurve : ContactLaw
  {
    double dent = 0., end = 0.; ///< indentations [m]
    double end_force = 0., power = 1.;

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
