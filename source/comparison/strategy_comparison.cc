#include "plate_impact/comparison/strategy_comparison.h"

#include <deal.II/base/timer.h>

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <new>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// States at which fields are compared with those of the reference.
    constexpr unsigned int n_compared_states = 20;

    /// Meshes with more cells are not drawn.
    constexpr unsigned int most_drawn_cells = 3000;

    /// Cells from which on a mesh, with every cell halved, makes a reference:
    /// a tenth of the target may be out of reach, by the estimator's limits on
    /// long transients.
    constexpr unsigned int enough_reference_cells = 4000;

    /// The error that meshes are made for over that of the mesh before, above
    /// which cells at the minimum size keep a curve from going on.
    constexpr double least_progress = 0.95;



    /// Goes on to smaller errors: whenever that of the goal meets the target,
    /// or the target gives no other mesh, it is halved, up to eight times from
    /// one mesh to the next.
    class HalvedTargets : public AdaptationControl
    {
    public:
      using AdaptationControl::AdaptationControl;

      /// Why the analysis ends with a cycle; empty when it goes on.
      std::function<std::optional<Outcome>(const CycleResult &)> end;

      std::optional<Outcome>
      check(const CycleResult &result) override
      {
        if (const auto outcome = end(result))
          return outcome;
        const double reached = error(result);
        if (result.cells_at_minimum_size > 0 &&
            reached > least_progress * error_before)
          return Outcome::minimum_cell_size;
        error_before = reached;
        n_halvings   = 0;
        while (reached <= target && tighten())
          ;
        return {};
      }

      bool
      tighten() override
      {
        if (n_halvings == 8 || marking != nullptr)
          return false;
        ++n_halvings;
        target *= 0.5;
        return true;
      }

    private:
      unsigned int n_halvings   = 0; ///< since the last cycle
      double       error_before = std::numeric_limits<double>::infinity();
    };



    /// The smallest cells of curves are smaller by this than those of a run
    /// that ends at the scene's target: targets are halved some five times, and
    /// at the edge of a load patch eta falls more slowly than the size.
    constexpr double size_at_smaller_targets = 8.;

    Parameters
    parameters_of(const Scene            &scene,
                  const ComparedStrategy &strategy,
                  const ElementType       element)
    {
      Parameters parameters             = scene.parameters;
      parameters.adaptivity.strategy    = strategy.strategy;
      parameters.adaptivity.goal        = strategy.goal;
      parameters.time.step_is_chosen    = false; // all take the same
      parameters.discretization.element = element;
      parameters.output.field_samples   = n_compared_states;
      parameters.output.write_report    = false;
      // meshes graded to the load take the size that they end with from it
      if (scene.given.adaptivity.minimum_cell_size == 0. &&
          !parameters.contact.load_is_singular() &&
          strategy.strategy != AdaptationStrategy::graded)
        parameters.adaptivity.minimum_cell_size /= size_at_smaller_targets;
      return parameters;
    }



    ComparedMesh
    compared(const Cycle &cycle, const Reference &reference)
    {
      ComparedMesh mesh;
      static_cast<CycleResult &>(mesh) = cycle.result;
      mesh.snapshots.clear(); // which are large
      const ContactHistory &history = *mesh.history;
      mesh.peak_force_error =
        std::abs(history.peak().force / reference.peak_force - 1.);
      mesh.is_comparable = mesh.peak_force_error > reference.uncertainty;
      if (!reference.computed)
        return mesh;
      const ContactHistory &fine = *reference.computed->history;
      const auto end = history.end_of_impact(), true_end = fine.end_of_impact();
      if (end && true_end)
        mesh.contact_end_error = std::abs(*end / *true_end - 1.);
      const bool is_whole =
        history.states.back().time == fine.states.back().time;
      if (reference.field_error && is_whole &&
          !(mesh.error->eta < 3. * reference.computed->error->eta))
        mesh.effectivity = mesh.error->eta /
          reference.field_error->of(cycle.discretization(),
                                    cycle.result.snapshots);
      return mesh;
    }



    /// @throws Outcome  out of a cycle that would exceed the time budget
    void
    add_meshes(StrategyComparison &comparison, ComparisonCurve &curve)
    {
      const Parameters parameters =
        parameters_of(comparison.scene, curve.strategy, curve.element);
      const Reference           &reference = comparison.reference;
      std::vector<ComparedMesh> &meshes    = curve.meshes;
      Timer                      timer; // of the next mesh
      const auto                 is_spent = [&] {
        return !meshes.empty() &&
          meshes.back().cumulative_seconds() + timer.wall_time() >
          parameters.comparison.time_budget;
      };
      HalvedTargets control(parameters.adaptivity);
      if (curve.strategy.is_outside)
        control.marking = comparison.marking;
      control.end = [&](const CycleResult &result) -> std::optional<Outcome> {
        if (is_spent())
          return Outcome::time_budget;
        // there is nothing to learn from a comparison
        if (reference.computed &&
            (parameters.adaptivity.goal == AdaptationGoal::peak_force ?
               control.error(result) < 3. * reference.uncertainty :
               result.error->eta < 3. * reference.computed->error->eta))
          return Outcome::nearly_as_fine_as_the_reference;
        if (result.cycle == parameters.comparison.maximum_cycles)
          return Outcome::maximum_cycles;
        return {};
      };
      ImpactAnalysis   analysis(parameters);
      AnalysisListener teller;
      teller.step = [&](auto cycle, auto step, auto n_steps) {
        if (is_spent())
          throw Outcome::time_budget;
        comparison.listener.step(cycle, step, n_steps);
      };
      teller.cycle = [&](Cycle &cycle) {
        // of the mesh that met the scene's target, or the last that is drawn
        const bool was_met = !meshes.empty() &&
          meshes.back().error->eta <= parameters.adaptivity.target_error;
        if (!was_met && cycle.result.cells <= most_drawn_cells)
          curve.picture =
            mesh_on_page(cycle.mesh(),
                         curve.name() + ": " +
                           std::to_string(cycle.result.cells) + " cells",
                         cycle.result.element_errors());
        meshes.push_back(compared(cycle, reference));
        curve.warnings = analysis.warnings;
        comparison.listener.cycle(cycle);
        timer.restart();
      };
      curve.end = word_for(analysis.run(control, teller));
    }
  } // namespace



  const Reference &
  StrategyComparison::compute_reference()
  {
    if (const double given = scene.parameters.comparison.reference_peak_force;
        given > 0.)
      {
        reference.peak_force = given;
        return reference;
      }
    const Parameters parameters =
      parameters_of(scene,
                    {AdaptationStrategy::hanging_nodes,
                     AdaptationGoal::energy_norm},
                    ElementType::MITC9);
    ImpactAnalysis analysis(parameters);
    HalvedTargets  until_fine(parameters.adaptivity),
      once(parameters.adaptivity);
    until_fine.end = [&](const CycleResult &result) -> std::optional<Outcome> {
      if (result.error->eta <= 0.1 * parameters.adaptivity.target_error ||
          result.cells >= enough_reference_cells)
        return Outcome::target_reached;
      return {};
    };
    once.end = [](const auto &) { return Outcome::single_mesh; };
    AnalysisListener teller;
    teller.step = listener.step;
    analysis.run(until_fine, teller);
    const double coarse_peak =
      analysis.last_cycle().result.history->peak().force;
    analysis.refine_everywhere();
    analysis.run(once, teller);
    CycleResult &fine = analysis.last_cycle().result;

    reference.peak_force = fine.history->peak().force;
    if (!(reference.peak_force > 0.))
      throw ComputationError("the peak force of the reference is " +
                             number(reference.peak_force) +
                             " N: there is nothing to compare with; choose a "
                             "longer Time/End time");
    // Ritz vectors have a tolerance of their own
    reference.uncertainty =
      std::max(std::abs(coarse_peak / reference.peak_force - 1.),
               fine.work.ritz_vectors > 0 ? parameters.time.ritz_tolerance :
                                            0.);
    if (!parameters.contact.load_is_singular())
      reference.field_error.emplace(analysis.last_cycle().discretization(),
                                    fine.snapshots);
    reference.computed = std::move(fine);
    return reference;
  }



  const ComparisonCurve &
  StrategyComparison::compute_curve(const ComparedStrategy &strategy,
                                    const ElementType       element)
  {
    ComparisonCurve &curve = curves.emplace_back();
    curve.strategy         = strategy;
    curve.element          = element;
    try
      {
        add_meshes(*this, curve);
      }
    catch (const Outcome outcome)
      {
        curve.end = word_for(outcome);
      }
    catch (const ComputationError &error)
      {
        curve.end = std::string("failed: ") + error.what();
      }
    catch (const std::bad_alloc &)
      {
        curve.end = "failed: not enough memory";
      }
    return curve;
  }
} // namespace PlateImpact
