#ifndef plate_impact_base_columns_h
#define plate_impact_base_columns_h

#include <cstddef>
#include <optional>
#include <string>

/// Columns of the tables that the program prints.
namespace PlateImpact
{
  /// @param format  of printf
  std::string
  formatted(const char *format, double value);

  /// A word at the left end of a column of some width.
  std::string
  left(std::size_t width, const std::string &word);

  /// A word at the right end.
  std::string
  right(std::size_t width, const std::string &word);

  /// A number, or a dash, at the right end.
  std::string
  column(std::size_t                  width,
         const char                  *format,
         const std::optional<double> &value);

  /// A value with six significant digits, as everywhere in the program's
  /// output; a dash when it is not finite.
  std::string
  six_digits(double value);
} // namespace PlateImpact

#endif
