#ifndef plate_impact_analysis_impact_analysis_h
#define plate_impact_analysis_impact_analysis_h

#include <deal.II/grid/tria.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/analysis/adaptation_control.h"
#include "plate_impact/analysis/cycle.h"
#include "plate_impact/analysis/model_warnings.h"
#include "plate_impact/analysis/outcome.h"
#include "plate_impact/analysis/time_control.h"
#include "plate_impact/base/parameters.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// Who follows an analysis.
  class AnalysisListener
  {
  public:
    virtual ~AnalysisListener() = default;

    /// Before what may take long.
    /// @param what  "assembly" and the like
    virtual void
    stage(unsigned int cycle, const std::string &what);

    /// After every step of a transient.
    virtual void
    step(unsigned int cycle, unsigned int step, unsigned int n_steps);

    /// After every cycle, before its mesh is adapted.
    virtual void
    cycle(Cycle &cycle);
  };


  /// The adaptive computation of an impact (Table 1 of the paper): the whole
  /// transient on a mesh, its error, a better mesh, until the error is met. The
  /// history starts anew on every mesh, so that nothing is interpolated between
  /// meshes. It writes nothing; a listener decides what becomes of a cycle.
  class ImpactAnalysis
  {
  public:
    /// Makes the first mesh, unless one is given.
    explicit ImpactAnalysis(
      const Parameters                         &parameters,
      std::unique_ptr<dealii::Triangulation<2>> mesh = nullptr);

    /// Computes on one mesh after another, beginning with the present one.
    /// @return why it ends
    /// @throws ComputationError naming step and quantity
    Outcome
    run(AdaptationControl &control, AnalysisListener &listener);

    /// The same to the target of the scene, with nobody listening.
    Outcome
    run();

    /// Halves every cell of the present mesh, whatever the strategy and the
    /// minimum cell size.
    void
    refine_everywhere();

    /// Computes the peak force of the last cycle again, with every cell of its
    /// mesh halved.
    /// @throws ComputationError naming step and quantity
    void
    verify();

    /// The last one; there is one after run().
    const Cycle &
    last_cycle() const;
    Cycle &
    last_cycle();

    /// What a user should know about the meshes so far.
    const std::vector<std::string> &
    warnings() const;

    /// All that a user should know about the last result, the meshes included.
    Warnings
    all_warnings() const;

  private:
    void
    build(AnalysisListener &listener);
    void
    strike(AnalysisListener &listener);
    /// One transient.
    void
    strike(const Parameters &on_mesh, AnalysisListener &listener);
    /// The last mesh again, if it was watched on the way to the peak only.
    void
    watch_to_the_end(AnalysisListener &listener);
    /// Of the peak force.
    void
    estimate_errors(const Parameters &on_mesh, const ContactHistory &history);
    /// Steps that were more than the vectors, on a mesh of so many unknowns.
    bool
    vectors_are_too_many(const Parameters &on_mesh) const;
    void
    estimate(AnalysisListener &listener);
    /// The error bar of the peak force.
    void
    bound(const PeakForceError &estimate, double error_of_vectors);
    /// By the goal of the scene.
    ErrorOverLimit
    over_limit(double target) const;
    /// Where there is no bar the mesh hides the load, or the waves that it
    /// sends out, from the estimate: one halving, whatever that says.
    void
    refine_at_load(ErrorOverLimit &error) const;
    std::optional<Outcome>
    adapt(AdaptationControl &control, AnalysisListener &listener);
    /// Whether vectors were fewer than steps.
    void
    note_vectors(const StruckPlate::Work &before,
                 const StruckPlate::Work &after);
    /// Matrices and factorizations are made when they are first needed: their
    /// seconds are taken out of the stage that was charged with them.
    void
    note_work(double &seconds_of_stage);

    const Parameters                            parameters;
    const std::unique_ptr<const MeshAdaptation> adaptation;

    std::unique_ptr<dealii::Triangulation<2>> mesh; ///< the next one
    std::unique_ptr<Cycle>    current;              ///< null before the first
    unsigned int              n_cycles         = 0;
    double                    seconds_for_mesh = 0.;
    std::vector<std::string>  adaptation_warnings;
    std::optional<PeakOnMesh> peak_here, peak_before; ///< mesh before

    /// Of the bending waves that the contact sends out. [m]
    double            contact_wave_length = 0.;
    TimeControl       time_control;
    StruckPlate::Work noted_work; ///< of the present cycle
    Parameters last_struck; ///< with the end time and the step of the cycle
    /// Unknowns from which vectors were more than steps, or nearly so, and as
    /// many steps.
    unsigned int unknowns_for_steps = std::numeric_limits<unsigned int>::max(),
                 steps_for_unknowns = 0;
  };
} // namespace PlateImpact

#endif
