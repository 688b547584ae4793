#include "plate_impact/base/text.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>

namespace PlateImpact
{
  PrefixedUnit::PrefixedUnit(const std::string &unit, const double value)
    : name(unit)
  {
    const double      largest    = std::abs(value);
    const std::string prefixes[] = {"p", "n", "µ", "m", "", "k", "M", "G", "T"};
    const bool        is_everyday = largest >= 1. && largest < 1e5;
    if (!std::isfinite(largest) || largest <= 0. || is_everyday)
      return;
    const int power =
      std::clamp(int(std::floor(std::log10(largest) / 3. + 1e-9)), -4, 4);
    name   = prefixes[power + 4] + unit;
    factor = std::pow(10., -3 * power);
  }



  namespace
  {
    /// Digits after the point with which an error is shown: two of 1 and 2, of
    /// which one would be coarse.
    int
    digits_of_error(const double error)
    {
      const int    power = int(std::floor(std::log10(error)));
      const double lead  = error / std::pow(10., power);
      return std::clamp(lead < 3. ? 1 - power : -power, 0, 9);
    }
  } // namespace



  std::string
  with_error(const double value, const double error, const std::string &unit)
  {
    const PrefixedUnit prefixed(unit, value);
    if (!(error > 0.) || !std::isfinite(error))
      return prefixed.text(value);
    return fmt::format("{:.{}f} {} ± {}",
                       prefixed(value),
                       digits_of_error(prefixed(error)),
                       prefixed.name,
                       error_in_words(error, value, unit));
  }



  std::string
  error_in_words(const double       error,
                 const double       value,
                 const std::string &unit)
  {
    const PrefixedUnit prefixed(unit, value);
    const int          digits       = digits_of_error(prefixed(error));
    const double       unit_of_last = std::pow(10., -digits);
    return fmt::format("{:.{}f} {}",
                       std::ceil(prefixed(error) / unit_of_last - 1e-9) *
                         unit_of_last,
                       digits,
                       prefixed.name);
  }



  std::string
  printable(std::string text)
  {
    for (char &letter : text)
      if (std::iscntrl(static_cast<unsigned char>(letter)))
        letter = '?';
    return text;
  }



  std::string
  in_ascii(const std::string &text)
  {
    using dealii::Utilities::replace_in_string;
    return replace_in_string(replace_in_string(text, "µ", "u"), "±", "+-");
  }
} // namespace PlateImpact
