#include "plate_impact/contact/contact_law.h"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <cstdint>

namespace PlateImpact
{
  namespace
  {
    using Curve = double (ContactLaw::*)(double) const;

    /// Mean of a curve between a and b, which is 0 below 0, where its integral
    /// begins. Template arguments: calls in the contact solve are many.
    template <Curve curve, Curve integral>
    double
    mean(const ContactLaw &law, const double a, const double b)
    {
      const auto f = [&](const double alpha) { return (law.*curve)(alpha); };
      const auto F = [&](const double alpha) { return (law.*integral)(alpha); };
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
  ContactLaw::mean_force(const double a, const double b) const
  {
    return mean<&ContactLaw::force, &ContactLaw::potential>(*this, a, b);
  }



  double
  ContactLaw::mean_stiffness(const double a, const double b) const
  {
    return mean<&ContactLaw::stiffness, &ContactLaw::force>(*this, a, b);
  }
} // namespace PlateImpact
