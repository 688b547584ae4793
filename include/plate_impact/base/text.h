#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <string>

/// Numbers and words that a user reads, by one rule everywhere: results have
/// four significant digits, or as many as their error leaves them, estimates
/// and advice three; both have the prefix of their unit that makes them easy to
/// read. Columns of numbers to compare have six. What a user may type into a
/// scene stands as it is typed, in the unit of the entry.
namespace PlateImpact
{
  /// A number of six digits; a dash when it is not finite.
  inline std::string
  number(const double value)
  {
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : "–";
  }

  /// A number of some significant digits, without an exponent where six would
  /// need none: 1310, not 1.31e+03.
  inline std::string
  rounded(const double value, const int digits = 4)
  {
    return number(
      std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr));
  }


  /// A unit with the prefix that makes values easy to read: of 3.43e-5 s it
  /// makes 34.3 µs. Forces and the like read better as 1301 N than as 1.301 kN:
  /// numbers from 1 to 1e5 have no prefix.
  struct PrefixedUnit
  {
    /// @param unit   of SI without prefix, such as "s"
    /// @param value  the largest to show; 0 or not finite: no prefix
    PrefixedUnit(const std::string &unit, double value);

    /// A value in this unit, from SI units.
    double
    operator()(const double value) const
    {
      return factor * value;
    }

    /// A result with the unit.
    std::string
    text(const double value, const int digits = 4) const
    {
      return rounded(factor * value, digits) + ' ' + name;
    }

    std::string name; ///< with the prefix
    double      factor = 1.;
  };


  /// A result with its unit.
  /// @param unit  of SI without prefix
  inline std::string
  number(const double value, const std::string &unit)
  {
    return PrefixedUnit(unit, value).text(value);
  }

  /// A result and how far it may be off, which is rounded up to one digit or,
  /// of 1 and 2, two: "1390.10 N ± 0.10 N".
  /// @param unit  of SI without prefix
  std::string
  with_error(double value, double error, const std::string &unit);

  /// The error alone, which is above 0, in the unit that the value has: "5 N".
  std::string
  error_in_words(double error, double value, const std::string &unit);

  /// A result, a fraction, as "5 %".
  inline std::string
  percentage(const double fraction)
  {
    return rounded(100. * fraction) + " %";
  }

  /// An estimate or advice.
  inline std::string
  about(const double value)
  {
    return rounded(value, 3);
  }
  inline std::string
  about(const double value, const std::string &unit)
  {
    return PrefixedUnit(unit, value).text(value, 3);
  }
  inline std::string
  about_percentage(const double fraction)
  {
    return about(100. * fraction) + " %";
  }

  /// How far a value is from another: "+0.56 %", or "12.6 times" where it is
  /// more than twice it or less than half.
  inline std::string
  deviation(const double value, const double other)
  {
    const double ratio = value / other;
    return ratio > 0.5 && ratio < 2. ?
      fmt::format("{:+.3g} %", 100. * (ratio - 1.)) :
      about(ratio) + " times";
  }

  /// The whole text as a finite number; no other word than a number matches.
  template <typename T>
  bool
  to_number(const std::string &text, T &value)
  {
    const char *begin = text.data(), *end = begin + text.size();
    if (text.size() > 1 && text[0] == '+' && text[1] != '-')
      ++begin;
    const auto [last, error] = std::from_chars(begin, end, value);
    return error == std::errc() && last == end &&
      std::isfinite(static_cast<double>(value));
  }

  /// The shortest text that reads back as the same number.
  inline std::string
  shortest(const double value)
  {
    char       text[32];
    const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
    return {text, end};
  }

  /// "1 point", "2 points", "3 meshes".
  inline std::string
  counted(const std::size_t n, const std::string &noun)
  {
    const char *plural = noun.back() == 'h' ? "es" : "s";
    return fmt::format("{} {}{}", n, noun, n == 1 ? "" : plural);
  }

  /// A time that someone waits: "12 s", "3 min".
  inline std::string
  waiting_time(const double seconds)
  {
    if (seconds < 100.)
      return fmt::format("{:.0f} s", seconds);
    if (seconds < 6000.)
      return fmt::format("{:.0f} min", seconds / 60.);
    return fmt::format("{:.0f} h", seconds / 3600.);
  }

  /// On one line and without codes that a terminal obeys: names of files and
  /// values of entries may hold anything.
  std::string
  printable(std::string text);

  /// In the letters that every terminal has: u for µ, +- for ±.
  std::string
  in_ascii(const std::string &text);

  /// Columns of the tables that the program prints: a word at the right end of
  /// a column of some width.
  inline std::string
  right(const std::size_t width, const std::string &word)
  {
    return fmt::format("{:>{}}", word, width);
  }

  /// A number, or a dash for none and NaN, at the right end.
  /// @param format  of {fmt}, as "{:.2f}"
  inline std::string
  column(const std::size_t            width,
         const char                  *format,
         const std::optional<double> &value)
  {
    // never without a blank before it
    return ' ' +
      right(width - 1,
            value && !std::isnan(*value) ?
              fmt::format(fmt::runtime(format), *value) :
              "-");
  }
} // namespace PlateImpact
