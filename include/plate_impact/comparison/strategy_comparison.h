#pragma once

#include "plate_impact/analysis/goal.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/estimator/reference_error.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <functional>
#include <iosfwd>
#include <memory>
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

    std::optional<CycleResult> computed;     ///< none of a given force
    double                     seconds = 0.; ///< that it has taken

    /// None under a point load, whose energy has no limit.
    std::shared_ptr<const ReferenceError> field_error;
  };


  /// A mesh of a curve. Errors are relative to the reference, as fractions.
  struct ComparedMesh
  {
    unsigned int          cycle, cells, degrees_of_freedom;
    unsigned int          cells_at_minimum_size; ///< that would be refined
    double                eta, peak_force;       ///< [N]
    double                peak_force_error;
    std::optional<double> peak_force_bar; ///< none on blind meshes
    bool                  is_comparable;  ///< above the reference's uncertainty
    std::optional<double> contact_end_error;
    double                seconds, cumulative_seconds;

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
    ComparedStrategy              strategy;
    ElementType                   element;
    std::vector<ComparedMesh>     meshes;
    std::string                   end;     ///< why it ends there
    std::optional<ContactHistory> history; ///< of the last mesh
    std::vector<std::string>      warnings;
    Json picture; ///< of the mesh that meets eta; null: none was drawn

    /// "hanging nodes, MITC9"
    std::string
    name() const
    {
      return name_of(strategy) + ", " + word_for(element);
    }
  };


  /// A mesh from which on a curve stays below a threshold: of the force,
  /// confirmed by a later mesh or by its own bar.
  struct Achievement
  {
    const ComparisonCurve *curve;
    const ComparedMesh    *mesh;
  };


  /// Who reaches a threshold.
  struct ThresholdRow
  {
    bool   is_of_eta; ///< or of the error of the peak force
    double threshold;
    bool   is_comparable; ///< above the reference's uncertainty
    /// The fastest first; none where it is not comparable. Of eta, those whose
    /// meshes are made for it: by force, a plate is watched up to its peak.
    std::vector<Achievement> achievements;
    /// Which strategy is first, each with its fastest element, and by how much:
    /// against uniform meshes, or the next.
    std::string in_words;
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
  class StrategyComparison
  {
  public:
    const Scene &scene; ///< must outlive the comparison

    /// Told after every step: the cycle, the step and the number of steps.
    decltype(AnalysisListener::step) progress = AnalysisListener().step;

    const AdaptationControl *marking = nullptr; ///< of strategies outside

    Reference                    reference = {};
    std::vector<ComparisonCurve> curves    = {};

    /// The given peak force, or that of a mesh far finer than any compared:
    /// MITC9 and hanging nodes down to a tenth of the target error, then every
    /// cell halved. Needed before any curve.
    /// @throws ComputationError
    const Reference &
    compute_reference();

    /// Adds the curve of a strategy and an element; a failure ends it.
    /// @param listener  told after every mesh
    const ComparisonCurve &
    compute_curve(
      const ComparedStrategy                             &strategy,
      ElementType                                         element,
      const std::function<void(const ComparisonCurve &)> &listener =
        [](const ComparisonCurve &) {});

    /// Who reaches 5, 2, 1, 0.5, 0.3 and 0.1 % of peak-force error, and of eta.
    std::vector<ThresholdRow>
    thresholds() const;

  private:
    void
    add_meshes(ComparisonCurve                                    &curve,
               const std::function<void(const ComparisonCurve &)> &listener);
  };


  /// comparison.json: the reference, every mesh of every curve, who reaches
  /// which error first (doc/results.md has the keys).
  Json
  comparison_results(const Scene                    &scene,
                     const StrategyComparison       &comparison,
                     const std::vector<std::string> &warnings);

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
