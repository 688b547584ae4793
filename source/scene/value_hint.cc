#include "plate_impact/scene/value_hint.h"

#include "plate_impact/base/text.h"

#include <algorithm>
#include <map>
#include <regex>
#include <utility>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    /// Units that people write, in those of entries.
    const std::map<std::string, std::pair<double, std::string>> units = {
      {"m", {1., "m"}},
      {"cm", {1e-2, "m"}},
      {"mm", {1e-3, "m"}},
      {"um", {1e-6, "m"}},
      {"s", {1., "s"}},
      {"ms", {1e-3, "s"}},
      {"us", {1e-6, "s"}},
      {"kg", {1., "kg"}},
      {"g", {1e-3, "kg"}},
      {"t", {1e3, "kg"}},
      {"m/s", {1., "m/s"}},
      {"mm/s", {1e-3, "m/s"}},
      {"km/h", {1. / 3.6, "m/s"}},
      {"Pa", {1., "Pa"}},
      {"kPa", {1e3, "Pa"}},
      {"MPa", {1e6, "Pa"}},
      {"N/mm^2", {1e6, "Pa"}},
      {"GPa", {1e9, "Pa"}},
      {"kg/m^3", {1., "kg/m^3"}},
      {"kg/m3", {1., "kg/m^3"}},
      {"g/cm^3", {1e3, "kg/m^3"}},
      {"g/cm3", {1e3, "kg/m^3"}},
      {"N", {1., "N"}},
      {"kN", {1e3, "N"}},
      {"%", {1e-2, "-"}}};

    /// Other words for those of scenes.
    const std::vector<std::pair<std::string, std::string>> synonyms = {
      {"fixed", "clamped"},
      {"built-in", "clamped"},
      {"built in", "clamped"},
      {"encastre", "clamped"},
      {"fully fixed", "clamped"},
      {"hinged", "simply supported"},
      {"pinned", "simply supported"},
      {"ball", "sphere"},
      {"roller", "cylinder"},
      {"circular", "circle"},
      {"disc", "circle"},
      {"rectangular", "rectangle"},
      {"square", "rectangle"},
      {"yes", "true"},
      {"on", "true"},
      {"no", "false"},
      {"off", "false"}};



    /// A number with a unit after it, in the unit of the entry.
    std::string
    converted(const std::string &value, const std::string &unit)
    {
      static const std::regex number_and_unit(
        R"(([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([A-Za-z%][A-Za-z0-9/^]*))");
      std::smatch parts;
      if (!std::regex_match(value, parts, number_and_unit))
        return {};
      const auto found = units.find(parts[2]);
      if (found == units.end())
        return {};
      const auto &[factor, of_entry] = found->second;
      return of_entry == unit ?
        fmt::format("{:.6g}", std::stod(parts[1]) * factor) :
        "";
    }
  } // namespace



  std::string
  hint_for(const std::string &value, const Entry &entry)
  {
    const std::string unit = entry.unit();
    if (const std::string number = converted(value, unit); !number.empty())
      return "; write " + number + (unit == "-" ? "" : ", in " + unit);
    static const std::regex decimal_comma(R"([-+]?[0-9]+,[0-9]+)");
    if (std::regex_match(value, decimal_comma) &&
        entry.allowed.rfind("a number", 0) == 0)
      {
        std::string with_point = value;
        std::replace(with_point.begin(), with_point.end(), ',', '.');
        return "; write " + with_point + ", with a point";
      }
    for (const auto &[other, word] : synonyms)
      if (value == other && entry.allowed.find(word) != std::string::npos)
        return "; did you mean '" + word + "'?";
    return {};
  }
} // namespace PlateImpact
