#ifndef plate_impact_base_prefixed_unit_h
#define plate_impact_base_prefixed_unit_h

#include <string>
#include <vector>

namespace PlateImpact
{
  /// A unit with the prefix that makes values easy to read: of 3.43e-5 s it
  /// makes 34.3 µs.
  class PrefixedUnit
  {
  public:
    /// @param unit     of SI without prefix, such as "s"
    /// @param value  the largest to show; 0 or not finite: no prefix
    PrefixedUnit(const std::string &unit, double value);

    /// For the largest of some values.
    PrefixedUnit(const std::string &unit, const std::vector<double> &values);

    /// A value in this unit, from SI units.
    double
    operator()(double value) const;
    std::vector<double>
    operator()(std::vector<double> values) const;

    /// With six digits and the unit.
    std::string
    text(double value) const;

    const std::string &
    name() const;

  private:
    std::string prefixed;
    double      factor;
  };
} // namespace PlateImpact

#endif
