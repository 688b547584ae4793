#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/analysis/goal.h"
#include "plate_impact/analysis/time_control.h"
#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/parameters.h"

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
  /// meshes. It writes nothing; a listener decides what becomes of a cycle.
  class ImpactAnalysis
  {
  public:
    /// @param first_mesh  null: made for the scene
    /// @param wanted      in place of what the scene asks for
    explicit ImpactAnalysis(
      const Parameters                         &parameters,
      std::unique_ptr<dealii::Triangulation<2>> first_mesh = nullptr,
      const std::optional<Wanted>              &wanted     = {});

    /// Computes on one mesh after another, beginning with the first, or with
    /// that of refine_everywhere().
    /// @return why it ends
    /// @throws ComputationError naming step and quantity
    Outcome
    run(AdaptationControl &control, AnalysisListener &listener);

    /// The same to the target of the scene, with nobody listening.
    Outcome
    run()
    {
      AdaptationControl control(parameters.adaptivity);
      AnalysisListener  nobody;
      return run(control, nobody);
    }

    /// Refines every cell of the present mesh, whatever the strategy and the
    /// minimum cell size.
    void
    refine_everywhere();

    /// Computes the peak force of the last cycle again, with every cell of its
    /// mesh refined.
    /// @throws ComputationError naming step and quantity
    void
    verify();

    /// The last one; there is one after run().
    Cycle &
    last_cycle() const
    {
      return *current;
    }

    /// All that a user should know about the last result, the meshes included.
    Warnings
    all_warnings() const;

    /// What a user should know about the meshes so far.
    std::vector<std::string> warnings;

  private:
    /// All that belongs to the next mesh.
    void
    begin_cycle(AnalysisListener &listener);
    /// Strikes the plate until that is enough to judge the mesh.
    void
    watch(AnalysisListener &listener);
    /// Begins the first cycle again, without the cells that are too long for
    /// waves that come back before the peak.
    void
    refine_for_waves(AnalysisListener &listener);
    /// The transient of the window; its history alone, where nothing but the
    /// time of its peak is wanted.
    void
    observe(AnalysisListener &listener);
    Judgement
    judgement() const;
    std::optional<double>
    mesh_part_of_bar() const;
    std::optional<Outcome>
    adapt(AdaptationControl &control, AnalysisListener &listener);

    Parameters                       parameters; ///< with singular points
    const Wanted                     wanted;
    const std::optional<TimeControl> time_control; ///< of an impactor

    std::unique_ptr<dealii::Triangulation<2>> mesh; ///< the next one
    std::unique_ptr<Cycle>    current;              ///< null before the first
    unsigned int              n_cycles         = 0;
    double                    seconds_for_mesh = 0.;
    std::optional<PeakOnMesh> before; ///< on the mesh before the current one
    Window                    window; ///< the last, or the next

    /// Of a mesh on which Ritz vectors were more than steps, or nearly so: a
    /// finer mesh needs more vectors, and one of about its size as many.
    unsigned int unknowns_in_vain = std::numeric_limits<unsigned int>::max(),
                 steps_in_vain    = 0;
  };
} // namespace PlateImpact
