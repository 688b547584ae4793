#pragma once

#include "plate_impact/comparison/strategy_comparison.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// comparison.json: the reference, every mesh of every curve, who reaches
  /// which error first (doc/results.md has the keys).
  Json
  comparison_results(const Scene                    &scene,
                     const StrategyComparison       &comparison,
                     const std::vector<std::string> &warnings);

  /// Which strategy reaches a threshold first, each with its fastest element,
  /// and by how much: against uniform meshes, or the next.
  std::string
  in_words(const ThresholdRow &row, const std::vector<ComparisonCurve> &curves);

  /// comparison.csv: the meshes of all curves, a row each.
  void
  write_comparison_table(std::ostream                       &out,
                         const std::vector<ComparisonCurve> &curves);

  /// comparison.html.
  /// @param results  of comparison_results()
  void
  write_comparison_page(std::ostream             &out,
                        const Scene              &scene,
                        const StrategyComparison &comparison,
                        const Json               &results);
} // namespace PlateImpact
