#include "plate_impact/base/columns.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace PlateImpact
{
  namespace
  {
    std::string
    filling(const std::size_t width, const std::string &word)
    {
      return std::string(width - std::min(width, word.size()), ' ');
    }
  } // namespace



  std::string
  formatted(const char *format, const double value)
  {
    char text[64];
    std::snprintf(text, sizeof(text), format, value);
    return text;
  }



  std::string
  left(const std::size_t width, const std::string &word)
  {
    return word + filling(width, word);
  }



  std::string
  right(const std::size_t width, const std::string &word)
  {
    return filling(width, word) + word;
  }



  std::string
  column(const std::size_t            width,
         const char                  *format,
         const std::optional<double> &value)
  {
    // never without a blank before it
    return ' ' + right(width - 1, value ? formatted(format, *value) : "-");
  }



  std::string
  six_digits(const double value)
  {
    if (!std::isfinite(value))
      return "–";
    char text[32];
    std::snprintf(text, sizeof(text), "%.6g", value);
    return text;
  }
} // namespace PlateImpact
