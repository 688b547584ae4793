#ifndef plate_impact_analysis_impact_analysis_h
#define plate_impact_analysis_impact_analysis_h

#include <deal.II/grid/tria.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/analysis/cycle_result.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/base/stage_clock.h"
#include "plate_impact/contact/contact_law.h"
#include "plate_impact/contact/contact_solver.h"
#include "plate_impact/estimator/error_estimator.h"
#include "plate_impact/estimator/kelly_indicator.h"
#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/plate/plate_element.h"
#include "plate_impact/transient/ritz_reduction.h"
#include "plate_impact/transient/time_stepper.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// The adaptive computation of an impact (Table 1 of the paper): the whole
  /// transient on a mesh, its error, a better mesh, until the error is met. The
  /// history starts anew on every mesh, so that nothing is interpolated between
  /// meshes and what belongs to one lives and dies with its cycle. It writes
  /// nothing; run_scene() and the comparison of strategies decide what becomes
  /// of a cycle.
  class ImpactAnalysis
  {
  public:
    /// Told after every step: the cycle, the step and the number of steps.
    using Progress =
      std::function<void(unsigned int, unsigned int, unsigned int)>;

    /// Makes the first mesh, unless one is given.
    /// @param parameters  must outlive the analysis
    explicit ImpactAnalysis(
      const Parameters                         &parameters,
      const Progress                           &progress = {},
      std::unique_ptr<dealii::Triangulation<2>> mesh     = nullptr);

    /// The transient and its error on the present mesh.
    /// @throws ComputationError naming step and quantity
    CycleResult
    compute_cycle();

    /// Why the loop ends with this result; empty when it goes on.
    std::optional<std::string>
    outcome(const CycleResult &result) const;

    /// Makes the mesh that a result asks for the present one, unless it is the
    /// same again or has too many cells.
    /// @return why the loop ends instead; empty when the mesh has changed
    std::optional<std::string>
    adapt(const CycleResult &result, double target_error);

    /// Halves every cell, whatever the strategy and the minimum cell size.
    void
    refine_everywhere();

    /// What a user should know about the meshes so far.
    const std::vector<std::string> &
    warnings() const;

    /// The present mesh, and what was made on it; the law is null without an
    /// impactor, the estimator where nothing asks for one.
    const dealii::Triangulation<2> &
    mesh() const;
    const PlateDiscretization &
    model() const;
    const ErrorEstimator *
    estimator() const;
    const ContactLaw *
    contact_law() const;

  private:
    void
    run_transient(CycleResult &result, StageClock &clock);
    /// @param reduced  the plate that is stepped; null: that of the mesh
    void
    step_to_end(TimeStepper         &stepper,
                const ReducedSystem *reduced,
                CycleResult         &result,
                StageClock          &clock);
    /// @throws ComputationError where an energy that is kept has changed
    void
    require_energy(const ContactHistory &history) const;
    /// What the history answers to another step and another velocity.
    /// @param n_solves  of the plate, counted on
    void
    judge_steps(SemidiscreteSystem &plate,
                bool                is_reduced,
                const Impactor     &impactor,
                CycleResult        &result,
                unsigned int       &n_solves) const;
    bool
    is_snapshot(unsigned int step, unsigned int n_steps) const;
    /// Cells nearer to a point load than half the thickness.
    std::vector<unsigned int>
    singular_cells() const;
    /// Whether a point lies under a line load; empty for other loads.
    std::function<bool(const dealii::Point<2> &)>
    line_load() const;
    void
    judge_mesh(CycleResult &result, StageClock &clock);

    const Parameters                               &parameters;
    const Progress                                  progress;
    const bool                                      has_estimator;
    const PlateElement                              element;
    const std::unique_ptr<const ContactLaw>         law;
    const std::unique_ptr<const ContactIntegration> contact_integration;
    const std::unique_ptr<const MeshAdaptation>     adaptation;
    const std::vector<LoadPoint>                    load_patch;

    std::unique_ptr<dealii::Triangulation<2>> triangulation;
    double                   seconds_for_mesh = 0.; ///< to make the present one
    unsigned int             cycle            = 0;
    std::vector<std::string> adaptation_warnings;
    /// Unknowns from which Ritz vectors were more than steps, or nearly so.
    unsigned int too_many_for_vectors =
      std::numeric_limits<unsigned int>::max();

    /// of the cycle; the estimator refers to the model, the model to the mesh
    std::unique_ptr<PlateDiscretization> discretization;
    std::unique_ptr<ErrorEstimator>      error_estimator;
    std::unique_ptr<KellyIndicator>      kelly; ///< null for another indicator
  };
} // namespace PlateImpact

#endif
