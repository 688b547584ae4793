#pragma once

#include <functional>

namespace PlateImpact
{
  /// Where an increasing function of an indentation is 0. [m]
  double
  zero_of(const std::function<double(double)> &increasing);


  /// Force between two bodies as their indentation grows for the first time:
  /// zero for negative ones; neither force nor slope ever decrease. Series and
  /// memory belong to Contact.
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

    /// (U(b) - U(a)) / (b - a) with U the potential, without cancellation: the
    /// discrete gradient of Gonzalez (1996), doi:10.1007/BF02440162. [N]
    double
    mean_force(double a, double b) const;

    /// (F(b) - F(a)) / (b - a), without cancellation. [N/m]
    double
    mean_stiffness(double a, double b) const;
  };
} // namespace PlateImpact
