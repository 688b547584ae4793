#include "plate_impact/impact_analysis.h"

#include <deal.II/base/timer.h>

#include "plate_impact/exceptions.h"
#include "plate_impact/impactor.h"
#include "plate_impact/linear_solver.h"
#include "plate_impact/plate_mesh.h"
#include "plate_impact/reliability.h"
#include "plate_impact/ritz_basis.h"
#include "plate_impact/semidiscrete_plate.h"
#include "plate_impact/time_stepper.h"

#include <algorithm>
#include <limits>
#include <new>
#include <sstream>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Fewer samples over the transient do not make an integral over time.
    constexpr unsigned int min_estimator_samples = 20;



    /// Adds the time until its end to a stage.
    class Stopwatch
    {
    public:
      explicit Stopwatch(double &seconds)
        : seconds(seconds)
      {}

      ~Stopwatch()
      {
        seconds += timer.wall_time();
      }

    private:
      double     &seconds;
      const Timer timer;
    };
  } // namespace



  ImpactAnalysis::ImpactAnalysis(const Parameters &parameters,
                                 const Progress   &progress)
    : parameters(parameters)
    , progress(progress)
    , has_estimator(parameters.has_impactor() &&
                    (parameters.adaptivity.strategy != "none" ||
                     parameters.output.write_report ||
                     parameters.output.field_samples > 0))
    , element(parameters.discretization.element)
    , law(parameters.has_impactor() ? make_contact_law(parameters) : nullptr)
    , contact_integration(
        make_contact_integration(parameters.contact.integration))
    , adaptation(parameters.has_impactor() ?
                   make_mesh_adaptation(parameters.adaptivity) :
                   nullptr)
    , load_patch(
        parameters.has_impactor() ?
          make_load_patch(parameters.contact, parameters.impactor.length) :
          std::vector<LoadPoint>())
  {
    const Stopwatch stopwatch(seconds_for_mesh);
    triangulation =
      make_plate_quadrant(parameters.plate,
                          parameters.discretization.initial_cells);
  }



  CycleResult
  ImpactAnalysis::compute_cycle()
  {
    CycleResult result;
    result.cycle        = ++cycle;
    result.seconds.mesh = seconds_for_mesh;
    {
      const Stopwatch stopwatch(result.seconds.assembly);
      plate_model =
        std::make_unique<PlateModel>(*triangulation, element, parameters.plate);
    }
    result.cells              = triangulation->n_active_cells();
    result.degrees_of_freedom = plate_model->n_unknowns();
    result.min_cell_size      = std::numeric_limits<double>::max();
    for (const auto &cell : triangulation->active_cell_iterators())
      result.min_cell_size = std::min(result.min_cell_size, cell_size(cell));

    // a plate at rest stays at rest
    if (parameters.has_impactor())
      run_transient(result);
    if (has_estimator)
      estimate_error(result);
    return result;
  }



  bool
  ImpactAnalysis::adapt(const CycleResult &result)
  {
    seconds_for_mesh = 0.;
    const Stopwatch stopwatch(seconds_for_mesh);
    // whoever keeps the last mesh needs its model: adapt a copy
    auto adapted = std::make_unique<Triangulation<2>>();
    adapted->copy_triangulation(*triangulation);
    if (!adaptation->adapt(*adapted, *result.error))
      return false;
    error_estimator.reset();
    plate_model.reset();
    triangulation = std::move(adapted);
    return true;
  }



  const Triangulation<2> &
  ImpactAnalysis::mesh() const
  {
    return *triangulation;
  }



  const PlateModel &
  ImpactAnalysis::model() const
  {
    return *plate_model;
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
  ImpactAnalysis::run_transient(CycleResult &result)
  {
    Seconds   &seconds = result.seconds;
    Timer      timer;
    const auto add_to = [&timer](double &stage) {
      stage += timer.wall_time();
      timer.restart();
    };

    plate_model->assemble();
    MeshPlate mesh_plate(*plate_model,
                         plate_model->load(load_patch),
                         make_linear_solver(
                           parameters.discretization.linear_solver));
    add_to(seconds.assembly);
    const Impactor             impactor = make_impactor(parameters.impactor);
    std::unique_ptr<RitzBasis> basis;
    std::optional<RitzPlate>   ritz_plate;
    if (parameters.time.integrator == "Ritz vectors")
      {
        ++result.work.factorizations;
        basis = settled_ritz_basis(mesh_plate,
                                   plate_model->section(),
                                   parameters.time,
                                   *law,
                                   *contact_integration,
                                   impactor);
        if (basis)
          {
            ritz_plate.emplace(*basis);
            result.work.ritz_vectors  = basis->n_vectors();
            result.work.linear_solves = basis->n_vectors();
          }
        add_to(seconds.stepping);
      }
    SemidiscretePlate &plate =
      basis ? static_cast<SemidiscretePlate &>(*ritz_plate) : mesh_plate;
    const auto unknowns = [&](const Eigen::VectorXd &z) -> Eigen::VectorXd {
      if (!basis)
        return z;
      return basis->vectors() * ritz_plate->to_basis(z);
    };
    TimeStepper stepper(parameters.time,
                        plate,
                        *law,
                        *contact_integration,
                        impactor);
    add_to(seconds.factorization);
    if (has_estimator)
      error_estimator =
        std::make_unique<ErrorEstimator>(*plate_model,
                                         parameters.adaptivity.target_error,
                                         singular_cells(),
                                         line_load());
    add_to(seconds.estimation);

    const unsigned int n_steps = stepper.n_steps();
    const unsigned int interval =
      std::clamp(n_steps / min_estimator_samples,
                 1u,
                 parameters.adaptivity.sampling_interval);
    const unsigned int n_fields = parameters.output.field_samples;
    ContactHistory     history;
    history.add(stepper.state());
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        stepper.advance();
        history.add(stepper.state());
        const double time = stepper.state().time;
        // steps at which k n_steps / n_fields passes a whole number
        if (std::uint64_t(step) * n_fields / n_steps >
            std::uint64_t(step - 1) * n_fields / n_steps)
          result.snapshots.push_back({time, unknowns(stepper.displacement())});
        if (has_estimator && (step % interval == 0 || step == n_steps))
          {
            add_to(seconds.stepping);
            error_estimator->add_sample(time, unknowns(stepper.displacement()));
            add_to(seconds.estimation);
          }
        if (progress)
          progress(result.cycle, step, n_steps);
      }
    add_to(seconds.stepping);

    result.history         = std::move(history);
    result.steps           = n_steps;
    result.impulse         = stepper.impulse();
    result.separation_time = stepper.separation_time();
    if (!basis)
      {
        ++result.work.factorizations;
        result.work.linear_solves += stepper.n_linear_solves();
      }
    result.work.contact_steps += stepper.n_contact_steps();
  }



  std::vector<unsigned int>
  ImpactAnalysis::singular_cells() const
  {
    std::vector<unsigned int> cells;
    if (parameters.contact.load_distribution == "point")
      for (const auto &cell : triangulation->active_cell_iterators())
        if (cell->center().norm() < 0.5 * parameters.plate.thickness)
          cells.push_back(cell->active_cell_index());
    return cells;
  }



  std::function<bool(const Point<2> &)>
  ImpactAnalysis::line_load() const
  {
    if (parameters.contact.load_distribution != "line")
      return {};
    const double half_length = 0.5 * parameters.impactor.length;
    return [half_length](const Point<2> &point) {
      return point[1] == 0. && point[0] <= half_length;
    };
  }



  void
  ImpactAnalysis::estimate_error(CycleResult &result)
  {
    const Stopwatch stopwatch(result.seconds.estimation);
    result.error                  = error_estimator->estimate();
    result.work.estimator_samples = error_estimator->n_samples();
    for (const auto &cell : triangulation->active_cell_iterators())
      if (result.error->element_errors[cell->active_cell_index()] >= 1.)
        {
          ++result.cells_above_limit;
          if (is_smallest(cell, parameters.adaptivity))
            ++result.cells_at_minimum_size;
        }
  }



  std::optional<std::string>
  ImpactAnalysis::outcome(const CycleResult &result) const
  {
    if (adaptation == nullptr)
      return "single mesh";
    if (result.error->eta <= parameters.adaptivity.target_error &&
        result.cells_above_limit == result.cells_at_minimum_size)
      return "target reached";
    if (result.cycle == parameters.adaptivity.maximum_cycles)
      return "maximum cycles";
    return {};
  }
} // namespace PlateImpact
