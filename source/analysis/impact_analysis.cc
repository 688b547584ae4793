#include "plate_impact/analysis/impact_analysis.h"

#include "plate_impact/adaptation/graded_refinement.h"
#include "plate_impact/adaptation/make_mesh_adaptation.h"
#include "plate_impact/analysis/reliability.h"
#include "plate_impact/analysis/transient_record.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/stage_clock.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/newmark_scheme.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Times the target of the peak force.
    constexpr double near_target = 3.;
  } // namespace



  void
  AnalysisListener::step(unsigned int, unsigned int, unsigned int)
  {}



  void
  AnalysisListener::stage(const unsigned int, const std::string &)
  {}



  void
  AnalysisListener::cycle(Cycle &)
  {}



  ImpactAnalysis::ImpactAnalysis(const Parameters                 &parameters,
                                 std::unique_ptr<Triangulation<2>> first_mesh)
    : parameters(parameters)
    , adaptation(
        make_mesh_adaptation(parameters.adaptivity,
                             parameters.impactor.contact_half_length()))
    , mesh(std::move(first_mesh))
    , time_control(parameters)
    , last_struck(parameters)
  {
    StageClock clock;
    if (mesh == nullptr)
      {
        mesh = make_plate_mesh(parameters.plate,
                               parameters.discretization.initial_cells);
        if (parameters.adaptivity.is_adaptive() &&
            parameters.adaptivity.goal == AdaptationGoal::peak_force)
          refine_towards_load(*mesh, parameters);
      }
    if (parameters.has_impactor())
      contact_wave_length = contact_wave(parameters).length;
    clock.charge(seconds_for_mesh);
  }



  Outcome
  ImpactAnalysis::run(AdaptationControl &control, AnalysisListener &listener)
  {
    while (true)
      {
        build(listener);                               // unknowns on a mesh
        strike(listener);                              // K, M, the history
        estimate(listener);                            // eta and xi'
        auto outcome = control.check(current->result); // decide
        if (!outcome)
          outcome = adapt(control, listener); // the next mesh
        if (outcome)
          watch_to_the_end(listener);
        listener.cycle(*current); // tell
        if (outcome)
          return *outcome;
      }
  }



  Outcome
  ImpactAnalysis::run()
  {
    AdaptationControl control(parameters.adaptivity);
    AnalysisListener  nobody;
    return run(control, nobody);
  }



  void
  ImpactAnalysis::watch_to_the_end(AnalysisListener &listener)
  {
    if (!time_control.watch_to_the_end())
      return;
    strike(listener);
    estimate(listener);
  }



  void
  ImpactAnalysis::build(AnalysisListener &listener)
  {
    listener.stage(n_cycles + 1, "matrices");
    StageClock clock;
    if (mesh == nullptr) // the present one again
      mesh = copy_of(current->mesh());
    else
      peak_before = peak_here;
    const double seconds_before =
      current != nullptr ? current->result.cumulative_seconds() : 0.;
    current.reset();
    current = std::make_unique<Cycle>(++n_cycles, parameters, std::move(mesh));
    noted_work                     = {};
    current->result.seconds.mesh   = seconds_for_mesh;
    current->result.seconds_before = seconds_before;
    clock.charge(current->result.seconds.assembly);
  }



  void
  ImpactAnalysis::strike(AnalysisListener &listener)
  {
    // a plate at rest stays at rest
    if (!parameters.has_impactor())
      return;
    CycleResult &result = current->result;
    do
      {
        StageClock clock;
        if (parameters.time.end_time == 0.)
          listener.stage(result.cycle, "end of the contact");
        last_struck = time_control.next(current->plate);
        if (vectors_are_too_many(last_struck))
          last_struck.time.integrator = IntegratorType::Newmark;
        clock.charge(result.seconds.stepping);
        note_work(result.seconds.stepping);
        strike(last_struck, listener);
    } while (time_control.goes_on(
      *result.history,
      result.time_error,
      result.peak_force_error ? bar_of_mesh(*result.peak_force_error) : 0.,
      meets_force_target(result, parameters.adaptivity)));
  }



  void
  ImpactAnalysis::strike(const Parameters &on_mesh, AnalysisListener &listener)
  {
    CycleResult            &result = current->result;
    TransientRecord         record(parameters,
                           *current,
                           [&](const auto step, const auto n_steps) {
                             listener.step(result.cycle, step, n_steps);
                           });
    const StruckPlate::Work before = current->plate.work();
    listener.stage(result.cycle, "factors and vectors");
    Impact impact = current->plate.strike(on_mesh, record);
    record.finish();
    note_work(result.seconds.stepping);
    note_vectors(before, current->plate.work());
    listener.stage(result.cycle, "error of the force");
    estimate_errors(on_mesh, impact.history);
    StageClock clock;
    result.impulse            = impact.impulse;
    result.separation_time    = impact.separation_time;
    result.work.contact_steps = impact.n_contact_steps;
    result.history            = std::move(impact.history);
    clock.charge(result.seconds.stepping);
    if (result.peak_force_error)
      bound(*result.peak_force_error,
            impact.is_reduced ? parameters.time.ritz_tolerance : 0.);
  }



  void
  ImpactAnalysis::estimate_errors(const Parameters     &on_mesh,
                                  const ContactHistory &history)
  {
    CycleResult &result = current->result;
    StageClock   clock;
    result.sensitivity = current->plate.sensitivity(on_mesh, history);
    result.time_error  = current->plate.time_error(on_mesh, history);
    clock.charge(result.seconds.stepping);
    note_work(result.seconds.stepping);
    result.peak_force_error.reset();
    if (parameters.needs_estimator() && !parameters.contact.load_is_singular())
      if (const auto problem =
            current->plate.peak_force_problem(on_mesh, history))
        result.peak_force_error =
          estimated_peak_force_error(current->discretization(),
                                     current->recovery(),
                                     *problem->system,
                                     problem->motions,
                                     history.peak().force);
    if (parameters.adaptivity.is_adaptive() && !result.peak_force_error &&
        parameters.adaptivity.goal == AdaptationGoal::peak_force)
      throw ComputationError("cycle " + std::to_string(result.cycle) +
                             ": the error of the peak force cannot be "
                             "estimated, with no force or more than 20000 "
                             "steps to its peak; choose a larger Time/Time "
                             "step, or Adaptivity/Goal = energy norm");
    clock.charge(result.seconds.estimation);
    note_work(result.seconds.estimation);
  }



  bool
  ImpactAnalysis::vectors_are_too_many(const Parameters &on_mesh) const
  {
    // a finer mesh needs more vectors, and one of about this size as many
    return current->result.degrees_of_freedom >= unknowns_for_steps &&
      NewmarkScheme(on_mesh.time).n_steps <= steps_for_unknowns;
  }



  void
  ImpactAnalysis::note_vectors(const StruckPlate::Work &before,
                               const StruckPlate::Work &after)
  {
    const CycleResult &result    = current->result;
    const unsigned int n_vectors = after.ritz_vectors - before.ritz_vectors,
                       n_solves  = after.linear_solves - before.linear_solves;
    const bool was_in_vain =
      n_vectors > 0 && n_solves >= n_vectors + 0.5 * result.steps;
    if (was_in_vain || n_vectors > 0.7 * result.steps)
      {
        unknowns_for_steps = result.degrees_of_freedom / 2;
        steps_for_unknowns = result.steps;
      }
  }



  void
  ImpactAnalysis::note_work(double &seconds_of_stage)
  {
    CycleResult            &result = current->result;
    const StruckPlate::Work work   = current->plate.work();
    result.work.factorizations     = work.factorizations;
    result.work.linear_solves      = work.linear_solves;
    result.work.ritz_vectors       = work.ritz_vectors;
    const double assembly = work.assembly_seconds - noted_work.assembly_seconds,
                 factorization = work.factorization_seconds -
      noted_work.factorization_seconds;
    seconds_of_stage -= assembly + factorization;
    result.seconds.assembly += assembly;
    result.seconds.factorization += factorization;
    noted_work = work;
  }



  void
  ImpactAnalysis::estimate(AnalysisListener &listener)
  {
    if (current->estimator == nullptr)
      return;
    listener.stage(n_cycles, "error of the stresses");
    StageClock   clock;
    CycleResult &result           = current->result;
    result.error                  = current->estimator->estimate();
    result.work.estimator_samples = result.error->sample_times.size();
    result.over_limit =
      error_over_limit(*result.error, parameters.adaptivity.target_error);
    result.cells_above_limit = result.cells_at_minimum_size = 0;
    for (const auto &cell : current->mesh().active_cell_iterators())
      if (result.over_limit->elements[cell->active_cell_index()] >= 1.)
        {
          ++result.cells_above_limit;
          if (is_smallest(cell, parameters.adaptivity))
            ++result.cells_at_minimum_size;
        }
    clock.charge(result.seconds.estimation);
  }



  void
  ImpactAnalysis::bound(const PeakForceError &estimate,
                        const double          error_of_vectors)
  {
    CycleResult             &result  = current->result;
    const double             peak    = result.history->peak().force;
    const ContactParameters &contact = parameters.contact;
    const double load = contact.has_patch() ? 2. * contact.patch_radius :
                                              parameters.plate.thickness;
    // nor does a change of the force tell anything where no mesh sees the waves
    // that the contact sends out
    const double                wave = std::max(contact_wave_length, 2. * load);
    const std::optional<double> space = result.cell_size_at_load > 0.5 * wave ?
      std::nullopt :
      peak_force_error_by_mesh(estimate,
                               peak,
                               peak_before,
                               result.cell_size_at_load <= load);
    peak_here                         = PeakOnMesh{peak, space};
    result.peak_force_bar.reset();
    if (space && result.time_error)
      result.peak_force_bar = {*space, *result.time_error, error_of_vectors};
  }



  ErrorOverLimit
  ImpactAnalysis::over_limit(const double target) const
  {
    const CycleResult &result = current->result;
    if (parameters.adaptivity.goal == AdaptationGoal::energy_norm)
      return error_over_limit(*result.error, target);
    // What the time step leaves to the mesh, but a tenth of what there is at
    // most: estimates on coarse meshes do not tell more.
    const double   of_time = result.time_error.value_or(0.);
    ErrorOverLimit error =
      error_over_limit(*result.peak_force_error,
                       std::max({0.5 * target,
                                 target - of_time,
                                 0.1 * bar_of_mesh(*result.peak_force_error)}));
    // Near the target no cell grows: the estimate knows nothing of the waves
    // that a coarser mesh turns back after the window.
    if (error.overall < near_target)
      for (double &ratio : error.elements)
        ratio = std::max(ratio, 1. / near_target);
    if (!result.peak_force_bar && result.time_error)
      refine_at_load(error);
    return error;
  }



  void
  ImpactAnalysis::refine_at_load(ErrorOverLimit &error) const
  {
    const double halving = std::exp2(1. / parameters.adaptivity.size_exponent);
    for (const auto &cell : current->mesh().active_cell_iterators())
      if (is_near_load(cell, parameters.impactor.contact_half_length()))
        {
          double &ratio = error.elements[cell->active_cell_index()];
          ratio         = std::max(ratio, halving);
        }
    error.overall = std::max(error.overall, halving);
  }



  std::optional<Outcome>
  ImpactAnalysis::adapt(AdaptationControl &control, AnalysisListener &listener)
  {
    listener.stage(n_cycles, "next mesh");
    const unsigned int most_cells = parameters.adaptivity.maximum_cells;
    StageClock         clock;
    ErrorOverLimit     error;
    do
      {
        // whoever keeps the last cycle needs its mesh: adapt a copy
        auto adapted = copy_of(current->mesh());
        error        = over_limit(control.target_error());
        // before there is a mesh that does not fit into the memory
        if (adaptation->n_wanted_cells(*adapted, error) > most_cells)
          return Outcome::maximum_cells;
        if (adaptation->adapt(*adapted, error, adaptation_warnings))
          {
            if (adapted->n_active_cells() > most_cells)
              return Outcome::maximum_cells;
            if (current->result.history)
              time_control.begin_mesh(*current->result.history);
            mesh             = std::move(adapted);
            seconds_for_mesh = 0.;
            clock.charge(seconds_for_mesh);
            return {};
          }
    } while (control.tighten());
    return Outcome::mesh_unchanged;
  }



  void
  ImpactAnalysis::refine_everywhere()
  {
    StageClock clock;
    mesh = copy_of(current->mesh());
    mesh->refine_global();
    seconds_for_mesh = 0.;
    clock.charge(seconds_for_mesh);
  }



  void
  ImpactAnalysis::verify()
  {
    CycleResult &result = current->result;
    if (!result.history)
      return;
    StageClock clock;
    auto       halved = copy_of(current->mesh());
    halved->refine_global();
    // no longer than the peak takes, with nothing but the force
    Parameters          to_peak = last_struck;
    const NewmarkScheme scheme(to_peak.time);
    to_peak.time.time_step = scheme.dt;
    to_peak.time.horizon   = 0.;
    to_peak.time.end_time =
      std::min(to_peak.time.end_time,
               scheme.dt *
                 std::ceil(1.1 * result.history->peak().time / scheme.dt));
    to_peak.adaptivity.strategy  = AdaptationStrategy::none;
    to_peak.output.write_report  = false;
    to_peak.output.field_samples = 0;
    StruckPlate plate(to_peak.plate, to_peak.discretization, std::move(halved));
    const Impact impact = plate.strike(to_peak);
    result.verification =
      Verification{plate.discretization().mesh().n_active_cells(),
                   impact.history.peak().force};
    clock.charge(result.seconds.estimation);
  }



  const Cycle &
  ImpactAnalysis::last_cycle() const
  {
    return *current;
  }



  Cycle &
  ImpactAnalysis::last_cycle()
  {
    return *current;
  }



  const std::vector<std::string> &
  ImpactAnalysis::warnings() const
  {
    return adaptation_warnings;
  }



  Warnings
  ImpactAnalysis::all_warnings() const
  {
    Warnings warnings =
      reliability_warnings(last_struck, current->mesh(), current->result);
    warnings.numerical.insert(warnings.numerical.end(),
                              adaptation_warnings.begin(),
                              adaptation_warnings.end());
    return warnings;
  }
} // namespace PlateImpact
