#include "plate_impact/sweep/sweep_computation.h"

#include <deal.II/base/utilities.h>

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/plate_model.h"

#include <cmath>
#include <new>
#include <tuple>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Calls a function.
    /// @return why it failed, empty when it did not
    template <typename Function>
    std::string
    failure_of(const Function &function)
    {
      try
        {
          function();
          return {};
        }
      catch (const std::bad_alloc &)
        {
          return "not enough memory";
        }
      catch (const ExceptionBase &error)
        {
          return std::string("an internal error: ") + error.get_exc_name();
        }
      catch (const std::exception &error)
        {
          return Utilities::replace_in_string(error.what(), "\n", "; ");
        }
    }
  } // namespace



  SweepRow
  SweepComputation::compute(const std::size_t group, const std::size_t point)
  {
    SweepRow row;
    row.point   = point;
    row.failure = failure_of([&] {
      const SweepPoint valid  = scene.point(point);
      auto [result, warnings] = compute(group, valid);
      const ComputedImpact impact{valid.parameters, valid.expected, result};
      for (const ImpactQuantity &quantity : impact_quantities)
        row.quantities.push_back(quantity.value(impact).value_or(std::nan("")));
      row.warnings = std::move(warnings);
      row.warnings.insert(row.warnings.end(),
                          mesh_warnings.begin(),
                          mesh_warnings.end());
      if (valid.parameters.sweep.write_histories)
        row.history = std::move(*result.history);
    });
    return row;
  }



  SweepComputation::Computed
  SweepComputation::compute(const std::size_t group, const SweepPoint &point)
  {
    const Parameters &parameters = point.parameters;
    if (parameters.adaptivity.is_adaptive() &&
        parameters.sweep.adapt == SweepAdaptation::each_point)
      return analyse(parameters, nullptr);

    if (current_group != group)
      {
        plate_model.reset();
        mesh_warnings.clear();
        current_group = group;
        failure       = failure_of([&] {
          auto mesh     = make_mesh(group, point);
          min_cell_size = smallest_cell_size(*mesh);
          plate_model   = std::make_unique<PlateModel>(parameters.plate,
                                                     parameters.discretization,
                                                     std::move(mesh));
          ++work.plates;
        });
      }
    if (plate_model == nullptr)
      throw ComputationError("the plate of this point: " + failure);

    if (parameters.sweep.estimate_error)
      {
        Parameters on_mesh          = parameters;
        on_mesh.adaptivity.strategy = AdaptationStrategy::none;
        return analyse(on_mesh, copy_of(plate_model->discretization().mesh()));
      }
    return strike(point);
  }



  SweepComputation::Computed
  SweepComputation::strike(const SweepPoint &point)
  {
    const unsigned int loads_before = plate_model->work().loads;
    const bool         needs_states = point.parameters.needs_estimator();
    const Parameters   parameters =
      until_contact_ends(*plate_model, point.parameters, needs_states);
    const LoadedPlate plate  = plate_model->under(parameters, needs_states);
    const Impact      impact = plate.strike();
    work.loads += plate_model->work().loads - loads_before;

    const Triangulation<2> &mesh = plate_model->discretization().mesh();
    CycleResult             result;
    result.history       = impact.history;
    result.impulse       = impact.impulse;
    result.sensitivity   = plate.sensitivity(impact.history);
    result.min_cell_size = min_cell_size;
    // an adapted mesh was judged with the worst point
    const ComputedImpact computed{parameters, point.expected, result};
    const Warnings       warnings = parameters.adaptivity.is_adaptive() ?
            impact_warnings(computed) :
            reliability_warnings(computed, mesh);
    return {std::move(result), warnings.all()};
  }



  std::unique_ptr<Triangulation<2>>
  SweepComputation::make_mesh(const std::size_t group, const SweepPoint &point)
  {
    ++work.meshes;
    if (!point.parameters.adaptivity.is_adaptive())
      return make_plate_mesh(point.parameters.plate,
                             point.parameters.discretization.initial_cells);
    const SweepPoint worst = worst_point(group);
    ImpactAnalysis   analysis(worst.parameters);
    analysis.run();
    mesh_warnings           = analysis.warnings;
    const CycleResult &last = analysis.last_cycle().result;
    work.meshes += last.cycle - 1;
    if (const std::string warning =
          make_goal(worst.parameters.adaptivity)->warning(last);
        !warning.empty())
      mesh_warnings.push_back(
        "on the mesh adapted for the point with the shortest contact, " +
        warning);
    return copy_of(analysis.last_cycle().mesh());
  }



  SweepPoint
  SweepComputation::worst_point(const std::size_t group)
  {
    std::optional<SweepPoint> worst;
    const auto                severity = [](const SweepPoint &point) {
      return std::make_tuple(-point.expected.peak.time,
                             point.expected.peak.force);
    };
    for (const std::size_t index : groups.groups[group])
      try
        {
          const SweepPoint point = scene.point(index);
          if (!worst || severity(point) > severity(*worst))
            worst = point;
        }
      catch (const InputError &)
        {
          // it gets its row when its turn comes
        }
    return *worst;
  }



  SweepComputation::Computed
  SweepComputation::analyse(const Parameters                 &parameters,
                            std::unique_ptr<Triangulation<2>> mesh)
  {
    Wanted errors;
    errors.errors = true;
    ImpactAnalysis analysis(parameters, std::move(mesh), errors);
    analysis.run();
    const CycleResult &last = analysis.last_cycle().result;
    if (parameters.adaptivity.is_adaptive())
      {
        work.meshes += last.cycle;
        work.plates += last.cycle;
      }
    work.loads += last.cycle;
    return {last, analysis.all_warnings().all()};
  }
} // namespace PlateImpact
