#pragma once

#include "plate_impact/analysis/goal.h"
#include "plate_impact/estimator/energy_norm_estimator.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What results are compared with.
  struct Reference
  {
    double peak_force = 0.; ///< [N]

    /// Of the peak force, a fraction: its change by halving every cell once
    /// more, no less than the tolerance of Ritz vectors. 0 of a given force.
    double uncertainty = 0.;

    std::optional<CycleResult> computed; ///< none of a given force

    /// None under a point load, whose energy has no limit.
    std::optional<ReferenceError> field_error;
  };


  /// The result of a mesh of a curve, without snapshots, and its errors
  /// relative to the reference, as fractions.
  struct ComparedMesh : CycleResult
  {
    double                peak_force_error = 0.;
    bool                  is_comparable    = false; ///< above its uncertainty
    std::optional<double> contact_end_error;

    /// Estimated over true error, where the reference is three times better.
    std::optional<double> effectivity;
  };


  /// Its word in a scene, or "outside marking".
  inline std::string
  name_of(const ComparedStrategy &strategy)
  {
    return strategy.is_outside ? "outside marking" : word_for(strategy);
  }


  /// What a strategy achieves with an element, mesh by mesh.
  struct ComparisonCurve
  {
    ComparedStrategy          strategy;
    ElementType               element;
    std::vector<ComparedMesh> meshes;
    std::string               end; ///< why it ends there
    std::vector<std::string>  warnings;
    Json picture; ///< of the mesh that meets eta; null: none was drawn

    /// "hanging nodes, MITC9"
    std::string
    name() const
    {
      return name_of(strategy) + ", " + word_for(element);
    }
  };


  /// Strategies and elements side by side on one scene: error against what a
  /// user waits.
  ///
  /// All share the initial mesh, step, integrator, solver, load and estimator.
  /// Whenever eta meets the target, the target is halved; a mesh costs its own
  /// cycle and all before it. A curve ends at the comparison's maximum of
  /// cycles, with an eta of less than three times that of the reference, when
  /// its strategy keeps the mesh or gains nothing at the minimum cell size, or
  /// when the time budget is spent, which breaks off a cycle. A minimum cell
  /// size that the scene leaves to the program follows the smaller targets.
  struct StrategyComparison
  {
    const Scene &scene; ///< must outlive the comparison

    /// Told after every step, and after every mesh of a curve.
    AnalysisListener listener = {};

    Marking marking = {}; ///< of strategies outside

    Reference                    reference = {};
    std::vector<ComparisonCurve> curves    = {};

    /// The given peak force, or that of a mesh far finer than any compared:
    /// MITC9 and hanging nodes down to a tenth of the target error, then every
    /// cell halved. Needed before any curve.
    /// @throws ComputationError
    const Reference &
    compute_reference();

    /// Adds the curve of a strategy and an element; a failure ends it.
    const ComparisonCurve &
    compute_curve(const ComparedStrategy &strategy, ElementType element);
  };


  /// comparison.json: the reference, every mesh of every curve, who reaches
  /// 5, 2, 1, 0.5, 0.3 and 0.1 % of peak-force error first, and of eta, and
  /// what a reader should know before believing it (doc/results.md has the
  /// keys).
  Json
  comparison_results(const StrategyComparison &comparison);

  /// comparison.csv: the meshes of all curves, a row each.
  std::string
  comparison_table(const std::vector<ComparisonCurve> &curves);

  /// comparison.html.
  /// @param results  of comparison_results()
  std::string
  comparison_page(const StrategyComparison &comparison, const Json &results);
} // namespace PlateImpact
