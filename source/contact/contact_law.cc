#include "plate_impact/contact/contact_law.h"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cstdint>

namespace PlateImpact
{
  namespace
  {
    /// Mean of f between a and b, where F is its integral from 0 on and f is 0
    /// below.
    template <typename Function, typename Integral>
    double
    mean(const Function &f, const Integral &F, const double a, const double b)
    {
      const double low = std::min(a, b), high = std::max(a, b);
      if (high <= 0. || low == high)
        return f(high);
      if (low <= 0.)
        return F(high) / (high - low);
      if (high - low > 0.05 * high)
        return (F(high) - F(low)) / (high - low);
      // Close indentations, where the quotient cancels: Gauss quadrature is
      // exact to round-off for a law that is smooth on the scale of the
      // indentation.
      return boost::math::quadrature::gauss<double, 10>::integrate(f,
                                                                   low,
                                                                   high) /
        (high - low);
    }
  } // namespace



  double
  zero_of(const std::function<double(double)> &increasing)
  {
    std::uintmax_t n_iterations = 500;
    return boost::math::tools::bracket_and_solve_root(
             increasing,
             /*guess=*/1e-6,
             /*factor=*/2.,
             /*rising=*/true,
             boost::math::tools::eps_tolerance<double>(),
             n_iterations)
      .first;
  }



  double
  ContactLaw::indentation(const double force) const
  {
    return force <= 0. ? 0. : zero_of([&](const double alpha) {
      return this->force(alpha) / force - 1.;
    });
  }



  double
  ContactLaw::mean_force(const double a, const double b) const
  {
    return mean([this](const double alpha) { return force(alpha); },
                [this](const double alpha) { return potential(alpha); },
                a,
                b);
  }



  double
  ContactLaw::mean_stiffness(const double a, const double b) const
  {
    return mean([this](const double alpha) { return stiffness(alpha); },
                [this](const double alpha) { return force(alpha); },
                a,
                b);
  }
} // namespace PlateImpact
