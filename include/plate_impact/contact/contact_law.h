#pragma once

#include <functional>
#include <optional>

namespace PlateImpact
{
  /// Where an increasing function of an indentation is 0. [m]
  double
  zero_of(const std::function<double(double)> &increasing);


  /// Force between two bodies as a function of their indentation, as it grows
  /// for the first time: zero for negative indentations, never decreasing, its
  /// slope never decreasing either. What gives way in series and what the
  /// contact remembers belong to Contact.
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
    indentation(double force) const;

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

    /// k of a law F = k alpha^{3/2}; empty for others. [N/m^{3/2}]
    virtual std::optional<double>
    hertz_coefficient() const
    {
      return {};
    }
  };
} // namespace PlateImpact
