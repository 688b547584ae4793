#pragma once

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace PlateImpact
{
  using Json = nlohmann::ordered_json;

  /// What a page says, as text that is escaped here: whatever stands in the
  /// name or the entries of a scene stays text.
  struct PageText
  {
    std::string title, lead;
    std::string words; ///< all that a reader without JavaScript sees
  };

  /// Writes a study in one file that any browser shows without a network:
  /// report.html, comparison.html, sweep.html.
  /// @param study  numbers and words; `study` says which of the scripts of
  ///               source/page shows it: run.js, comparison.js or sweep.js,
  ///               where its keys can be looked up
  void
  write_page(std::ostream &out, const PageText &text, const Json &study);

  /// Numbers for a page, which shows no more than six digits; null for what is
  /// not finite.
  Json
  numbers_on_page(const std::vector<double> &values);
} // namespace PlateImpact
