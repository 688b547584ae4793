#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  using Json = nlohmann::ordered_json;

  /// Adds a value, where there is one.
  inline void
  add_known(Json                        &json,
            const std::string           &key,
            const std::optional<double> &value)
  {
    if (value)
      json[key] = *value;
  }

  /// What a page says, as text that is escaped here: whatever stands in the
  /// name or the entries of a scene stays text.
  struct PageText
  {
    std::string title, lead;
    std::string words; ///< all that a reader without JavaScript sees
  };

  /// A study as one file that any browser shows without a network: report.html,
  /// comparison.html, sweep.html.
  /// @param study  numbers and words; `study` says which of the scripts of
  ///               source/page shows it: run.js, comparison.js or sweep.js,
  ///               where its keys can be looked up
  std::string
  page(const PageText &text, const Json &study);

  /// Numbers for a page, which shows no more than six digits; null for what is
  /// not finite.
  template <typename Numbers = std::vector<double>>
  Json
  numbers_on_page(const Numbers &values)
  {
    Json numbers = Json::array();
    for (const double value : values)
      numbers.push_back(
        std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr));
    return numbers;
  }

  /// A mesh for a page: `title`, `vertices` (x and y of each [m]), `cells`
  /// (four vertices of each, lexicographic), and `fields`, with xi' as the
  /// first where it is known.
  Json
  mesh_on_page(const dealii::Triangulation<2> &mesh,
               const std::string              &title,
               const std::vector<double>      &errors);

  /// What pictures of meshes need of a scene: `patch`, the load around the
  /// origin, with its `radius` [m], 0 without one, and `isDisc`; `symmetric`,
  /// whether the plate mirrors in x = 0 and y = 0.
  Json
  plate_on_page(const Parameters &parameters);
} // namespace PlateImpact
