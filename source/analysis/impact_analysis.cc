#include "plate_impact/analysis/impact_analysis.h"

#include "plate_impact/adaptation/graded_refinement.h"
#include "plate_impact/adaptation/make_mesh_adaptation.h"
#include "plate_impact/analysis/reliability.h"
#include "plate_impact/analysis/transient_record.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/stage_clock.h"
#include "plate_impact/plate/plate_mesh.h"

#include <string>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  void
  AnalysisListener::step(unsigned int, unsigned int, unsigned int)
  {}



  void
  AnalysisListener::cycle(Cycle &)
  {}



  ImpactAnalysis::ImpactAnalysis(const Parameters                 &parameters,
                                 std::unique_ptr<Triangulation<2>> first_mesh)
    : parameters(parameters)
    , adaptation(make_mesh_adaptation(parameters.adaptivity,
                                      parameters.impactor.is_cylinder() ?
                                        0.5 * parameters.impactor.length :
                                        0.))
    , mesh(std::move(first_mesh))
  {
    StageClock clock;
    if (mesh == nullptr)
      {
        mesh = make_plate_quadrant(parameters.plate,
                                   parameters.discretization.initial_cells);
        if (parameters.adaptivity.is_adaptive() &&
            parameters.adaptivity.goal == AdaptationGoal::peak_force)
          refine_towards_load(*mesh, parameters);
      }
    clock.charge(seconds_for_mesh);
  }



  Outcome
  ImpactAnalysis::run(AdaptationControl &control, AnalysisListener &listener)
  {
    while (true)
      {
        build();                  // unknowns on a mesh
        strike(listener);         // K, M, the history
        estimate();               // eta and xi'
        listener.cycle(*current); // tell
        if (const auto outcome = control.check(current->result)) // decide
          return *outcome;
        if (const auto outcome = adapt(control)) // the next mesh
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
  ImpactAnalysis::build()
  {
    StageClock clock;
    if (mesh == nullptr) // the present one again
      mesh = copy_of(current->mesh());
    current.reset();
    current = std::make_unique<Cycle>(++n_cycles, parameters, std::move(mesh));
    current->result.seconds.mesh = seconds_for_mesh;
    clock.charge(current->result.seconds.assembly);
  }



  void
  ImpactAnalysis::strike(AnalysisListener &listener)
  {
    // a plate at rest stays at rest
    if (!parameters.has_impactor())
      return;
    CycleResult &result  = current->result;
    Parameters   on_mesh = parameters;
    // a finer mesh needs more vectors, and one of about this size as many
    if (result.degrees_of_freedom >= too_many_for_vectors)
      on_mesh.time.integrator = IntegratorType::Newmark;
    TransientRecord record(parameters,
                           *current,
                           [&](const auto step, const auto n_steps) {
                             listener.step(result.cycle, step, n_steps);
                           });
    Impact          impact = current->plate.strike(on_mesh, record);
    record.finish();

    StageClock clock;
    result.sensitivity = current->plate.sensitivity(on_mesh, impact.history);
    result.time_error  = current->plate.time_error(on_mesh, impact.history);
    clock.charge(result.seconds.stepping);
    if (parameters.needs_estimator() && !parameters.contact.load_is_singular())
      if (const auto problem =
            current->plate.peak_force_problem(on_mesh, impact.history))
        result.peak_force_error =
          estimated_peak_force_error(current->discretization(),
                                     current->recovery(),
                                     *problem->system,
                                     problem->motions,
                                     impact.history.peak().force);
    if (parameters.adaptivity.is_adaptive() && !result.peak_force_error &&
        parameters.adaptivity.goal == AdaptationGoal::peak_force)
      throw ComputationError("cycle " + std::to_string(result.cycle) +
                             ": the error of the peak force cannot be "
                             "estimated, with no force or more than 20000 "
                             "steps to its peak; choose a larger Time/Time "
                             "step, or Adaptivity/Goal = energy norm");
    clock.charge(result.seconds.estimation);
    result.impulse            = impact.impulse;
    result.separation_time    = impact.separation_time;
    result.work.contact_steps = impact.n_contact_steps;
    result.history            = std::move(impact.history);
    clock.charge(result.seconds.stepping);
    note_work(current->plate.work());
  }



  void
  ImpactAnalysis::note_work(const StruckPlate::Work &work)
  {
    CycleResult &result      = current->result;
    const bool   was_in_vain = work.ritz_vectors > 0 &&
      work.linear_solves >= work.ritz_vectors + 0.5 * result.steps;
    if (was_in_vain || work.ritz_vectors > 0.7 * result.steps)
      too_many_for_vectors = result.degrees_of_freedom / 2;
    result.work.factorizations = work.factorizations;
    result.work.linear_solves  = work.linear_solves;
    result.work.ritz_vectors   = work.ritz_vectors;
    // within the steps, when they are first needed
    result.seconds.stepping -= work.assembly_seconds;
    result.seconds.stepping -= work.factorization_seconds;
    result.seconds.assembly += work.assembly_seconds;
    result.seconds.factorization += work.factorization_seconds;
  }



  void
  ImpactAnalysis::estimate()
  {
    if (current->estimator == nullptr)
      return;
    StageClock   clock;
    CycleResult &result           = current->result;
    result.error                  = current->estimator->estimate();
    result.work.estimator_samples = result.error->sample_times.size();
    result.over_limit =
      error_over_limit(*result.error, parameters.adaptivity.target_error);
    for (const auto &cell : current->mesh().active_cell_iterators())
      if (result.over_limit->elements[cell->active_cell_index()] >= 1.)
        {
          ++result.cells_above_limit;
          if (is_smallest(cell, parameters.adaptivity))
            ++result.cells_at_minimum_size;
        }
    if (result.peak_force_error)
      bound(*result.peak_force_error);
    clock.charge(result.seconds.estimation);
  }



  void
  ImpactAnalysis::bound(const PeakForceError &estimate)
  {
    CycleResult             &result  = current->result;
    const double             peak    = result.history->peak().force;
    const ContactParameters &contact = parameters.contact;
    const double load = contact.has_patch() ? 2. * contact.patch_radius :
                                              parameters.plate.thickness;
    const std::optional<double> space =
      peak_force_error_by_mesh(estimate,
                               peak,
                               peak_before,
                               result.min_cell_size <= load);
    peak_before = PeakOnMesh{peak, space};
    if (space && result.time_error)
      result.peak_force_bar = {*space,
                               *result.time_error,
                               result.work.ritz_vectors > 0 ?
                                 parameters.time.ritz_tolerance :
                                 0.};
  }



  ErrorOverLimit
  ImpactAnalysis::over_limit(const double target) const
  {
    const CycleResult &result = current->result;
    if (parameters.adaptivity.goal == AdaptationGoal::energy_norm)
      return error_over_limit(*result.error, target);
    // what the time step leaves to the mesh
    const double of_time = result.time_error.value_or(0.);
    return error_over_limit(*result.peak_force_error,
                            std::max(0.5 * target, target - of_time));
  }



  std::optional<Outcome>
  ImpactAnalysis::adapt(AdaptationControl &control)
  {
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
            mesh             = std::move(adapted);
            seconds_for_mesh = 0.;
            clock.charge(seconds_for_mesh);
            return {};
          }
    } while (control.tighten());
    return error.overall <= 1. ? Outcome::target_reached :
                                 Outcome::mesh_unchanged;
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



  std::vector<std::string>
  ImpactAnalysis::all_warnings() const
  {
    std::vector<std::string> warnings =
      reliability_warnings(parameters, current->mesh(), current->result);
    warnings.insert(warnings.end(),
                    adaptation_warnings.begin(),
                    adaptation_warnings.end());
    return warnings;
  }
} // namespace PlateImpact
