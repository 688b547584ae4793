#ifndef plate_impact_impact_analysis_h
#define plate_impact_impact_analysis_h

#include <deal.II/grid/tria.h>

#include "plate_impact/console.h"
#include "plate_impact/contact_law.h"
#include "plate_impact/contact_solver.h"
#include "plate_impact/cycle_result.h"
#include "plate_impact/error_estimator.h"
#include "plate_impact/load_patch.h"
#include "plate_impact/mesh_adaptation.h"
#include "plate_impact/output.h"
#include "plate_impact/plate_element.h"
#include "plate_impact/plate_model.h"
#include "plate_impact/scene.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// The adaptive computation of an impact (Table 1 of the paper): the whole
  /// transient on a mesh, its error, a better mesh, until the error is met. The
  /// history starts anew on every mesh, so that nothing is interpolated between
  /// meshes and what belongs to one lives and dies with its cycle.
  class ImpactAnalysis
  {
  public:
    /// @param scene  must outlive the analysis
    ImpactAnalysis(const Scene &scene, Console &console);

    /// Computes and writes everything.
    /// @throws ComputationError; files written so far are then valid, and
    ///         summary.json tells of the failure
    void
    run();

  private:
    void
    run_cycles(Output &output);
    CycleResult
    compute_cycle(unsigned int cycle, double seconds_for_mesh);
    void
    run_transient(CycleResult &result);
    /// Cells nearer to a point load than half the thickness.
    std::vector<unsigned int>
    singular_cells() const;
    /// Whether a point lies under a line load; empty for other loads.
    std::function<bool(const dealii::Point<2> &)>
    line_load() const;
    void
    estimate_error(CycleResult &result);

    /// Why the loop ends with this result; empty when it goes on.
    std::optional<std::string>
    outcome(const CycleResult &result) const;

    const Scene                                    &scene;
    const Parameters                               &parameters;
    Console                                        &console;
    const bool                                      has_estimator;
    const PlateElement                              element;
    const std::unique_ptr<const ContactLaw>         contact_law;
    const std::unique_ptr<const ContactIntegration> contact_integration;
    const std::unique_ptr<const MeshAdaptation>     adaptation;
    const std::vector<LoadPoint>                    load_patch;

    std::unique_ptr<dealii::Triangulation<2>> mesh;

    /// of the cycle; the estimator refers to the model, the model to the mesh
    std::unique_ptr<PlateModel>     model;
    std::unique_ptr<ErrorEstimator> estimator;
  };
} // namespace PlateImpact

#endif
