#include "plate_impact/base/prefixed_unit.h"

#include "plate_impact/base/columns.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    double
    largest_of(const std::vector<double> &values)
    {
      double largest = 0.;
      for (const double value : values)
        if (std::isfinite(value))
          largest = std::max(largest, std::abs(value));
      return largest;
    }
  } // namespace



  PrefixedUnit::PrefixedUnit(const std::string &unit, const double value)
    : prefixed(unit)
    , factor(1.)
  {
    const double      largest    = std::abs(value);
    const std::string prefixes[] = {"p", "n", "µ", "m", "", "k", "M", "G", "T"};
    // forces read better as 1301 N than as 1.301 kN
    const bool is_everyday = largest >= 1. && largest < 1e5;
    if (!std::isfinite(largest) || largest <= 0. || is_everyday)
      return;
    const int power =
      std::clamp(int(std::floor(std::log10(largest) / 3. + 1e-9)), -4, 4);
    prefixed = prefixes[power + 4] + unit;
    factor   = std::pow(10., -3 * power);
  }



  PrefixedUnit::PrefixedUnit(const std::string         &unit,
                             const std::vector<double> &values)
    : PrefixedUnit(unit, largest_of(values))
  {}



  double
  PrefixedUnit::operator()(const double value) const
  {
    return factor * value;
  }



  std::vector<double>
  PrefixedUnit::operator()(std::vector<double> values) const
  {
    for (double &value : values)
      value *= factor;
    return values;
  }



  std::string
  PrefixedUnit::text(const double value) const
  {
    return six_digits(factor * value) + ' ' + prefixed;
  }



  const std::string &
  PrefixedUnit::name() const
  {
    return prefixed;
  }
} // namespace PlateImpact
