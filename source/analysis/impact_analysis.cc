#include "plate_impact/analysis/impact_analysis.h"

#include "plate_impact/adaptation/make_mesh_adaptation.h"
#include "plate_impact/analysis/reliability.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/estimator/sample_buffer.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/linear_solver.h"
#include "plate_impact/transient/ritz_reduction.h"
#include "plate_impact/transient/semidiscrete_system.h"
#include "plate_impact/transient/time_error.h"
#include "plate_impact/transient/time_stepper.h"

#include <algorithm>
#include <new>
#include <sstream>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Fewer samples over the transient do not make an integral over time.
    constexpr unsigned int min_estimator_samples = 20;



    /// l of a contact along 0 <= x <= l, 0 for a sphere. [m]
    double
    contact_half_length(const Parameters &parameters)
    {
      return parameters.impactor.is_cylinder() ?
        0.5 * parameters.impactor.length :
        0.;
    }
  } // namespace



  ImpactAnalysis::ImpactAnalysis(const Parameters                 &parameters,
                                 const Progress                   &progress,
                                 std::unique_ptr<Triangulation<2>> mesh)
    : parameters(parameters)
    , progress(progress)
    , has_estimator(parameters.needs_estimator())
    , element(parameters.discretization.element)
    , law(parameters.has_impactor() ? make_contact_law(parameters) : nullptr)
    , contact_integration(
        make_contact_integration(parameters.contact.integration))
    , adaptation(parameters.has_impactor() ?
                   make_mesh_adaptation(parameters.adaptivity,
                                        contact_half_length(parameters)) :
                   nullptr)
    , load_patch(parameters.has_impactor() ?
                   make_load_distribution(parameters.contact,
                                          parameters.impactor.length) :
                   std::vector<LoadPoint>())
  {
    StageClock clock;
    triangulation = mesh ?
      std::move(mesh) :
      make_plate_quadrant(parameters.plate,
                          parameters.discretization.initial_cells);
    clock.charge(seconds_for_mesh);
  }



  CycleResult
  ImpactAnalysis::compute_cycle()
  {
    CycleResult result;
    result.cycle        = ++cycle;
    result.seconds.mesh = seconds_for_mesh;
    StageClock clock;
    discretization = std::make_unique<PlateDiscretization>(*triangulation,
                                                           element,
                                                           parameters.plate);
    clock.charge(result.seconds.assembly);
    result.cells              = triangulation->n_active_cells();
    result.degrees_of_freedom = discretization->n_unknowns();
    result.min_cell_size      = smallest_cell_size(*triangulation);

    // a plate at rest stays at rest
    if (parameters.has_impactor())
      run_transient(result, clock);
    if (has_estimator)
      judge_mesh(result, clock);
    return result;
  }



  std::optional<std::string>
  ImpactAnalysis::adapt(const CycleResult &result, const double target_error)
  {
    const AdaptivityParameters &adaptivity = parameters.adaptivity;
    const std::string           too_many   = "maximum cells";
    const ErrorOverLimit        over_limit =
      error_over_limit(*result.error, target_error);
    // before there is a mesh that does not fit into the memory
    if (adaptation->n_wanted_cells(*triangulation, over_limit) >
        adaptivity.maximum_cells)
      return too_many;
    StageClock clock;
    // whoever keeps the last mesh needs its model: adapt a copy
    auto adapted = std::make_unique<Triangulation<2>>();
    adapted->copy_triangulation(*triangulation);
    if (!adaptation->adapt(*adapted, over_limit, adaptation_warnings))
      return over_limit.overall <= 1. ? "target reached" : "mesh unchanged";
    if (adapted->n_active_cells() > adaptivity.maximum_cells)
      return too_many;
    seconds_for_mesh = 0.;
    clock.charge(seconds_for_mesh);
    kelly.reset();
    error_estimator.reset();
    discretization.reset();
    triangulation = std::move(adapted);
    return {};
  }



  void
  ImpactAnalysis::refine_everywhere()
  {
    StageClock clock;
    kelly.reset();
    error_estimator.reset();
    discretization.reset();
    triangulation->refine_global();
    seconds_for_mesh = 0.;
    clock.charge(seconds_for_mesh);
  }



  const std::vector<std::string> &
  ImpactAnalysis::warnings() const
  {
    return adaptation_warnings;
  }



  const Triangulation<2> &
  ImpactAnalysis::mesh() const
  {
    return *triangulation;
  }



  const PlateDiscretization &
  ImpactAnalysis::model() const
  {
    return *discretization;
  }



  const ErrorEstimator *
  ImpactAnalysis::estimator() const
  {
    return error_estimator.get();
  }



  const ContactLaw *
  ImpactAnalysis::contact_law() const
  {
    return law.get();
  }



  void
  ImpactAnalysis::run_transient(CycleResult &result, StageClock &clock)
  {
    discretization->assemble();
    FullSystem mesh_plate(*discretization,
                          discretization->load(load_patch),
                          make_linear_solver(
                            parameters.discretization.linear_solver));
    clock.charge(result.seconds.assembly);

    RitzReduction  reduction(mesh_plate,
                            discretization->section(),
                            parameters.time,
                            *contact_integration,
                            has_estimator);
    ReducedSystem *reduced = nullptr;
    if (parameters.time.integrator == IntegratorType::Ritz_vectors &&
        result.degrees_of_freedom < too_many_for_vectors)
      {
        reduced = reduction.settle(parameters);
        // a finer mesh needs more of them, and one of about this size as many
        const double n_steps =
          parameters.time.end_time / parameters.time.time_step;
        if (reduced == nullptr || reduced->n_vectors() > 0.7 * n_steps)
          too_many_for_vectors = result.degrees_of_freedom / 2;
      }
    SemidiscreteSystem &plate    = reduced != nullptr ?
         static_cast<SemidiscreteSystem &>(*reduced) :
         mesh_plate;
    const Impactor      impactor = make_impactor(parameters.impactor);
    unsigned int        n_solves = 0; // of the plate that is stepped
    {
      TimeStepper stepper(parameters.time,
                          plate,
                          *law,
                          *contact_integration,
                          impactor);
      clock.charge(result.seconds.stepping);
      step_to_end(stepper, reduced, result, clock);
      n_solves += stepper.n_linear_solves();
    }
    require_energy(*result.history);
    judge_steps(plate, reduced != nullptr, impactor, result, n_solves);
    clock.charge(result.seconds.stepping);
    // a basis or a stepper factorizes when it needs to
    const double factorizing = mesh_plate.factorization_seconds();
    result.seconds.stepping -= factorizing;
    result.seconds.factorization += factorizing;

    result.work.factorizations = mesh_plate.n_factorizations();
    result.work.ritz_vectors   = reduction.n_vectors();
    result.work.linear_solves =
      reduction.n_vectors() + (reduced != nullptr ? 0 : n_solves);
  }



  void
  ImpactAnalysis::require_energy(const ContactHistory &history) const
  {
    const double drift = history.relative_energy_drift();
    if (drift <= 1e-6 ||
        parameters.contact.integration != ForceIntegration::energy_conserving)
      return;
    std::ostringstream text;
    text << "the total energy, which the scheme keeps, changes by "
         << 100. * drift << " %";
    if (parameters.time.integrator == IntegratorType::Ritz_vectors)
      text << "; try Time/Integrator = Newmark";
    throw ComputationError(text.str());
  }



  void
  ImpactAnalysis::judge_steps(SemidiscreteSystem &plate,
                              const bool          is_reduced,
                              const Impactor     &impactor,
                              CycleResult        &result,
                              unsigned int       &n_solves) const
  {
    // A single contact changes in proportion. On the mesh, where a second
    // transient costs as much as the first, only the peak is asked for.
    const ContactHistory &history = *result.history;
    if (history.n_contacts() > 1 &&
        (is_reduced || history.peak().time > *history.first_contact_end()))
      result.sensitivity =
        sensitivity_to_velocity(history, impactor, [&](const Impactor &other) {
          TimeStepper    stepper(parameters.time,
                              plate,
                              *law,
                              *contact_integration,
                              other);
          ContactHistory struck = history_to_end(stepper);
          n_solves += stepper.n_linear_solves();
          return struck;
        });
    result.time_error = estimated_time_error(history,
                                             parameters.time,
                                             plate,
                                             *law,
                                             *contact_integration,
                                             impactor,
                                             n_solves);
  }



  void
  ImpactAnalysis::step_to_end(TimeStepper         &stepper,
                              const ReducedSystem *reduced,
                              CycleResult         &result,
                              StageClock          &clock)
  {
    if (has_estimator)
      error_estimator = std::make_unique<ErrorEstimator>(*discretization,
                                                         singular_cells(),
                                                         line_load());
    kelly.reset();
    if (has_estimator &&
        parameters.adaptivity.indicator == ErrorIndicator::Kelly)
      kelly = std::make_unique<KellyIndicator>(*discretization);
    const unsigned int n_steps = stepper.n_steps();
    const unsigned int interval =
      std::clamp(n_steps / min_estimator_samples,
                 1u,
                 parameters.adaptivity.sampling_interval);
    SampleBuffer   waiting(reduced, n_steps / interval + 1, result.cells);
    ReportedStates reported(reduced,
                            n_steps / interval,
                            result.degrees_of_freedom);
    const bool     has_report = parameters.output.write_report;
    if (has_report)
      error_estimator->keep_element_errors(reported.samples_per_frame());
    const auto judge = [&] {
      clock.charge(result.seconds.stepping);
      waiting.judge(*error_estimator, kelly.get());
      clock.charge(result.seconds.estimation);
    };
    clock.charge(result.seconds.estimation);

    ContactHistory history;
    history.add(stepper.state());
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        stepper.advance();
        history.add(stepper.state());
        if (is_snapshot(step, n_steps))
          result.snapshots.push_back(
            {stepper.state().time,
             reduced ?
               Eigen::VectorXd(reduced->unknowns(stepper.displacement())) :
               stepper.displacement()});
        const bool is_sample =
          has_estimator && (step % interval == 0 || step == n_steps);
        if (has_report)
          reported.take_step(stepper);
        if (has_report && is_sample)
          reported.take_sample(stepper);
        if (is_sample &&
            waiting.add(stepper.state().time, stepper.displacement()))
          judge();
        if (progress)
          progress(result.cycle, step, n_steps);
      }
    if (has_estimator)
      judge();

    result.peak_state         = reported.peak_state();
    result.frames             = reported.frames();
    result.history            = std::move(history);
    result.steps              = n_steps;
    result.impulse            = stepper.impulse();
    result.separation_time    = stepper.separation_time();
    result.work.contact_steps = stepper.n_contact_steps();
  }



  bool
  ImpactAnalysis::is_snapshot(const unsigned int step,
                              const unsigned int n_steps) const
  {
    const std::uint64_t n_fields = parameters.output.field_samples;
    // steps at which k n_steps / n_fields passes a whole number
    return step * n_fields / n_steps > (step - 1) * n_fields / n_steps;
  }



  std::vector<unsigned int>
  ImpactAnalysis::singular_cells() const
  {
    std::vector<unsigned int> cells;
    if (parameters.contact.load_is_singular())
      for (const auto &cell : triangulation->active_cell_iterators())
        if (cell->center().norm() < 0.5 * parameters.plate.thickness)
          cells.push_back(cell->active_cell_index());
    return cells;
  }



  std::function<bool(const Point<2> &)>
  ImpactAnalysis::line_load() const
  {
    if (!parameters.contact.load_is_line())
      return {};
    const double half_length = 0.5 * parameters.impactor.length;
    return [half_length](const Point<2> &point) {
      return point[1] == 0. && point[0] <= half_length;
    };
  }



  void
  ImpactAnalysis::judge_mesh(CycleResult &result, StageClock &clock)
  {
    result.error = error_estimator->estimate();
    if (kelly)
      kelly->distribute(*result.error);
    result.over_limit =
      error_over_limit(*result.error, parameters.adaptivity.target_error);
    result.work.estimator_samples = error_estimator->n_samples();
    for (const auto &cell : triangulation->active_cell_iterators())
      if (result.over_limit->elements[cell->active_cell_index()] >= 1.)
        {
          ++result.cells_above_limit;
          if (is_smallest(cell, parameters.adaptivity))
            ++result.cells_at_minimum_size;
        }
    clock.charge(result.seconds.estimation);
  }



  std::optional<std::string>
  ImpactAnalysis::outcome(const CycleResult &result) const
  {
    if (adaptation == nullptr)
      return "single mesh";
    if (result.over_limit->overall <= 1. &&
        result.cells_above_limit == result.cells_at_minimum_size)
      return "target reached";
    if (result.cycle == parameters.adaptivity.maximum_cycles)
      return "maximum cycles";
    return {};
  }
} // namespace PlateImpact
