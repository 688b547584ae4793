#include "plate_impact/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <string>

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
    const bool        is_everyday = largest >= 1. && largest < 1e5;
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
    return number(factor * value) + ' ' + prefixed;
  }



  const std::string &
  PrefixedUnit::name() const
  {
    return prefixed;
  }



  std::string
  number(const double value)
  {
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : "–";
  }



  std::string
  number(const double value, const std::string &unit)
  {
    return PrefixedUnit(unit, value).text(value);
  }



  std::string
  percentage(const double fraction)
  {
    return number(100. * fraction) + " %";
  }



  std::string
  about(const double value)
  {
    // rounded first, so that 1310 does not become 1.31e+03
    return number(std::strtod(fmt::format("{:.2e}", value).c_str(), nullptr));
  }



  std::string
  about(const double value, const std::string &unit)
  {
    const PrefixedUnit prefixed(unit, value);
    return about(prefixed(value)) + ' ' + prefixed.name();
  }



  std::string
  about_percentage(const double fraction)
  {
    return about(100. * fraction) + " %";
  }



  std::string
  shortest(const double value)
  {
    char       text[32];
    const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
    return {text, end};
  }



  std::string
  counted(const std::size_t n, const std::string &noun)
  {
    const char *plural = noun.back() == 'h' ? "es" : "s";
    return fmt::format("{} {}{}", n, noun, n == 1 ? "" : plural);
  }



  std::string
  wall_time(const double seconds)
  {
    return fmt::format("{:.2f} s", seconds);
  }



  std::string
  waiting_time(const double seconds)
  {
    if (seconds < 100.)
      return fmt::format("{:.0f} s", seconds);
    if (seconds < 6000.)
      return fmt::format("{:.0f} min", seconds / 60.);
    return fmt::format("{:.0f} h", seconds / 3600.);
  }



  std::string
  in_ascii(std::string text)
  {
    const std::string micro = "µ";
    for (std::size_t at; (at = text.find(micro)) != std::string::npos;)
      text.replace(at, micro.size(), "u");
    return text;
  }



  std::string
  left(const std::size_t width, const std::string &word)
  {
    return fmt::format("{:<{}}", word, width);
  }



  std::string
  right(const std::size_t width, const std::string &word)
  {
    return fmt::format("{:>{}}", word, width);
  }



  std::string
  column(const std::size_t            width,
         const char                  *format,
         const std::optional<double> &value)
  {
    // never without a blank before it
    return ' ' +
      right(width - 1, value ? fmt::format(fmt::runtime(format), *value) : "-");
  }
} // namespace PlateImpact
