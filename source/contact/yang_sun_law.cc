#include "plate_impact/contact/yang_sun_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace PlateImpact
{
  namespace
  {
    constexpr double unloading_power = 2.5, loading_power = 1.5;
  } // namespace



  YangSunLaw::YangSunLaw(const double coefficient,
                         const double critical_indentation)
    : k(coefficient)
    , critical(critical_indentation)
  {}



  double
  YangSunLaw::Branch::at(const double indentation) const
  {
    return force * std::pow((indentation - origin) / reach, power);
  }



  double
  YangSunLaw::Branch::slope(const double indentation) const
  {
    return power / reach * force *
      std::pow((indentation - origin) / reach, power - 1.);
  }



  double
  YangSunLaw::Branch::mean(const double low, const double high) const
  {
    // (y^(2n) - x^(2n)) / (y^2 - x^2) of n = power + 1, with x^2 and y^2 the
    // indentations from the origin, both divided by y - x
    const double x = std::sqrt((low - origin) / reach),
                 y = std::sqrt((high - origin) / reach);
    const int n    = std::lround(2. * (power + 1.));
    double    sum  = 0.;
    for (int i = 0; i < n; ++i)
      sum += std::pow(x, i) * std::pow(y, n - 1 - i);
    return force / (power + 1.) * sum / (x + y);
  }



  std::array<YangSunLaw::Branch, 3>
  YangSunLaw::branches() const
  {
    const double infinity      = std::numeric_limits<double>::infinity();
    const double largest_force = k * largest * std::sqrt(largest);
    return {
      {{dent, turn, dent, turn - dent, turn_force, unloading_power},
       {turn, largest, dent, largest - dent, largest_force, loading_power},
       {largest, infinity, 0., 1., k, loading_power}}};
  }



  YangSunLaw::Branch
  YangSunLaw::branch_at(const double indentation) const
  {
    for (const Branch &branch : branches())
      if (indentation <= branch.end)
        return branch;
    return branches().back();
  }



  double
  YangSunLaw::force(const double indentation) const
  {
    return indentation > dent ? branch_at(indentation).at(indentation) : 0.;
  }



  double
  YangSunLaw::stiffness(const double indentation) const
  {
    return indentation > dent ? branch_at(indentation).slope(indentation) : 0.;
  }



  double
  YangSunLaw::potential(const double indentation) const
  {
    return indentation > dent ?
      mean_force(dent, indentation) * (indentation - dent) :
      0.;
  }



  double
  YangSunLaw::mean_force(const double a, const double b) const
  {
    const double low = std::min(a, b), high = std::max(a, b);
    if (low == high)
      return force(low);
    double work = 0.;
    for (const Branch &branch : branches())
      {
        const double from = std::max(low, branch.begin),
                     to   = std::min(high, branch.end);
        if (from == low && to == high)
          return branch.mean(low, high);
        if (from < to)
          work += branch.mean(from, to) * (to - from);
      }
    return work / (high - low);
  }



  double
  YangSunLaw::indentation(const double force) const
  {
    if (force <= 0.)
      return 0.;
    for (const Branch &branch : branches())
      if (branch.end > branch.begin &&
          (std::isinf(branch.end) || force <= branch.at(branch.end)))
        return branch.origin +
          branch.reach * std::pow(force / branch.force, 1. / branch.power);
    return 0.;
  }



  double
  YangSunLaw::permanent_indentation() const
  {
    return dent;
  }



  YangSunLaw
  YangSunLaw::moved_to(const double indentation) const
  {
    YangSunLaw next = *this;
    next.last       = indentation;
    if (indentation > largest)
      {
        next.largest = indentation;
        next.dent    = indentation > critical ?
             indentation * (1. - std::pow(critical / indentation, 0.4)) :
             0.;
      }
    if (indentation > turn)
      {
        next.turn       = indentation;
        next.turn_force = force(indentation);
      }
    else if (indentation <= dent)
      {
        next.turn       = next.dent;
        next.turn_force = 0.;
      }
    return next;
  }



  double
  YangSunLaw::stored_energy(const double indentation) const
  {
    const double from_dent = indentation - moved_to(indentation).dent;
    return from_dent > 0. ?
      force(indentation) * from_dent / (unloading_power + 1.) :
      0.;
  }



  double
  YangSunLaw::dissipated_energy(const double indentation) const
  {
    const double work = mean_force(last, indentation) * (indentation - last);
    const double stored_before =
      last > dent ? force(last) * (last - dent) / (unloading_power + 1.) : 0.;
    return dissipated + work - (stored_energy(indentation) - stored_before);
  }



  std::unique_ptr<const ContactLaw>
  YangSunLaw::after(const double indentation) const
  {
    auto next        = std::make_unique<YangSunLaw>(moved_to(indentation));
    next->dissipated = dissipated_energy(indentation);
    return next;
  }
} // namespace PlateImpact
