#include "plate_impact/sweep/sweep_warnings.h"

#include <algorithm>
#include <regex>

namespace PlateImpact
{
  namespace
  {
    /// A sentence without its numbers and the prefixes of their units.
    std::string
    kind_of(const std::string &sentence)
    {
      static const std::regex number("[0-9][0-9.]*(e[-+]?[0-9]+)?"),
        prefix("# (p|n|µ|m|k|M|G|T)(m|s|N|J|Pa)\\b");
      return std::regex_replace(std::regex_replace(sentence, number, "#"),
                                prefix,
                                "# $2");
    }



    /// Points that have the same to tell.
    struct Kind
    {
      std::string name, first;
      std::size_t n_points;
    };
  } // namespace



  std::vector<std::string>
  sweep_warnings(const std::vector<std::optional<SweepRow>> &rows)
  {
    std::size_t       n_failed = 0;
    std::string       first_failure;
    std::vector<Kind> kinds;
    for (const auto &row : rows)
      {
        if (!row->failure.empty() && ++n_failed == 1)
          first_failure = row->failure;
        for (const std::string &warning : row->warnings)
          {
            const std::string name = kind_of(warning);
            const auto        kind =
              std::find_if(kinds.begin(), kinds.end(), [&](const Kind &k) {
                return k.name == name;
              });
            if (kind == kinds.end())
              kinds.push_back({name, warning, 1});
            else
              ++kind->n_points;
          }
      }

    const std::string        of_all = " of " + std::to_string(rows.size());
    std::vector<std::string> warnings;
    if (n_failed > 0)
      warnings.push_back(std::to_string(n_failed) + of_all +
                         " points failed; the first: " + first_failure);
    for (const Kind &kind : kinds)
      warnings.push_back(std::to_string(kind.n_points) + of_all +
                         " points; the first: " + kind.first);
    return warnings;
  }
} // namespace PlateImpact
