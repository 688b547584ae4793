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



  ImpactAnalysis::ImpactAnalysis(const Scene &scene, Console &console)
    : scene(scene)
    , parameters(scene.parameters)
    , console(console)
    , has_estimator(parameters.has_impactor() &&
                    (parameters.adaptivity.strategy != "none" ||
                     parameters.output.write_report ||
                     parameters.output.field_samples > 0))
    , element(parameters.discretization.element)
    , contact_law(parameters.has_impactor() ? make_contact_law(parameters) :
                                              nullptr)
    , contact_integration(
        make_contact_integration(parameters.contact.integration))
    , adaptation(parameters.has_impactor() ?
                   make_mesh_adaptation(parameters.adaptivity) :
                   nullptr)
    , load_patch(
        parameters.has_impactor() ?
          make_load_patch(parameters.contact, parameters.impactor.length) :
          std::vector<LoadPoint>())
  {}



  void
  ImpactAnalysis::run()
  {
    Output output(scene);
    try
      {
        run_cycles(output);
      }
    catch (const ComputationError &error)
      {
        output.write_failure(error.what());
        throw;
      }
    catch (const std::bad_alloc &)
      {
        output.write_failure("not enough memory");
        throw;
      }
  }



  void
  ImpactAnalysis::run_cycles(Output &output)
  {
    double seconds_for_mesh = 0.;
    {
      const Stopwatch stopwatch(seconds_for_mesh);
      mesh = make_plate_quadrant(parameters.plate,
                                 parameters.discretization.initial_cells);
    }
    console.begin(scene);
    for (unsigned int cycle = 1;; ++cycle)
      {
        CycleResult result = compute_cycle(cycle, seconds_for_mesh);
        output.write_cycle(result, *mesh);
        std::optional<std::string> end = outcome(result);

        seconds_for_mesh = 0.;
        if (!end)
          {
            const Stopwatch stopwatch(seconds_for_mesh);
            // the fields of a last mesh need its model: adapt a copy
            auto adapted = std::make_unique<Triangulation<2>>();
            adapted->copy_triangulation(*mesh);
            if (adaptation->adapt(*adapted, *result.error))
              {
                estimator.reset();
                model.reset();
                mesh = std::move(adapted);
              }
            else
              end = "mesh unchanged";
          }
        console.cycle(result);
        if (end)
          {
            if (!result.snapshots.empty())
              output.write_fields(result, *model, *estimator);
            std::vector<std::string> warnings;
            if (result.history)
              warnings = reliability_warnings(parameters,
                                              *mesh,
                                              model->section(),
                                              *contact_law,
                                              result);
            output.finish(*end, warnings);
            console.end(*end, result, warnings, output.main_files());
            return;
          }
      }
  }



  CycleResult
  ImpactAnalysis::compute_cycle(const unsigned int cycle,
                                const double       seconds_for_mesh)
  {
    CycleResult result;
    result.cycle        = cycle;
    result.seconds.mesh = seconds_for_mesh;
    {
      const Stopwatch stopwatch(result.seconds.assembly);
      model = std::make_unique<PlateModel>(*mesh, element, parameters.plate);
    }
    result.cells              = mesh->n_active_cells();
    result.degrees_of_freedom = model->n_unknowns();
    result.min_cell_size      = std::numeric_limits<double>::max();
    for (const auto &cell : mesh->active_cell_iterators())
      result.min_cell_size = std::min(result.min_cell_size, cell_size(cell));

    // a plate at rest stays at rest
    if (parameters.has_impactor())
      run_transient(result);
    if (has_estimator)
      estimate_error(result);
    return result;
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

    model->assemble();
    MeshPlate mesh_plate(*model,
                         model->load(load_patch),
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
                                   model->section(),
                                   parameters.time,
                                   *contact_law,
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
                        *contact_law,
                        *contact_integration,
                        impactor);
    add_to(seconds.factorization);
    if (has_estimator)
      estimator =
        std::make_unique<ErrorEstimator>(*model,
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
            estimator->add_sample(time, unknowns(stepper.displacement()));
            add_to(seconds.estimation);
          }
        console.progress(result.cycle, step, n_steps);
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
      for (const auto &cell : mesh->active_cell_iterators())
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
    result.error                  = estimator->estimate();
    result.work.estimator_samples = estimator->n_samples();
    for (const auto &cell : mesh->active_cell_iterators())
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
