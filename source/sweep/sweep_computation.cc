#include "plate_impact/sweep/sweep_computation.h"

#include <deal.II/base/utilities.h>

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <tuple>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// What an entry changes.
    enum Level
    {
      impactor,
      load,
      plate
    };

    Level
    level(const std::string &path)
    {
      const std::string section = path.substr(0, path.find('/'));
      if (path == "Impactor/Length" || path == "Impactor/Shape")
        return load;
      if (section == "Impactor" || path == "Contact/Law" ||
          path == "Plate/Yield strength" || path == "Ply/Mode II toughness")
        return impactor;
      return section == "Contact" || section == "Time" ? load : plate;
    }



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



  SweepGroups::SweepGroups(const SweepPlan &plan, const Parameters &parameters)
  {
    const bool is_adaptive = plan.may_adapt(parameters),
               law_changes_plate =
                 parameters.plate.is_laminate() || plan.sweeps("Plate/Layup");
    // numbers in the order in which their first points come
    std::map<std::string, std::size_t> number_of_group, number_of_load;
    std::vector<std::size_t>           load_of(plan.n_points);
    for (std::size_t point = 0; point < plan.n_points; ++point)
      {
        const std::vector<std::string> values = plan.values(point);
        std::string                    plate_key, load_key;
        for (std::size_t i = 0; i < values.size(); ++i)
          {
            const std::string &path    = plan.entries[i].path;
            const Level        changes = level(path);
            if (changes == plate ||
                (law_changes_plate && path == "Contact/Law") ||
                (is_adaptive && changes == load))
              plate_key += values[i] + '\n';
            else if (changes == load)
              load_key += values[i] + '\n';
          }
        const auto [group, is_new] =
          number_of_group.emplace(plate_key, groups.size());
        if (is_new)
          groups.emplace_back();
        groups[group->second].push_back(point);
        load_of[point] =
          number_of_load.emplace(plate_key + load_key, number_of_load.size())
            .first->second;
      }
    n_loads = number_of_load.size();
    for (auto &group : groups)
      std::stable_sort(group.begin(), group.end(), [&](auto p, auto q) {
        return load_of[p] < load_of[q];
      });
  }



  std::vector<SweepGroups::Task>
  SweepGroups::tasks(const std::vector<bool> &to_do,
                     const std::size_t        most_points) const
  {
    std::vector<Task> tasks;
    for (std::size_t group = 0; group < groups.size(); ++group)
      {
        bool is_new = true;
        for (const std::size_t point : groups[group])
          if (to_do[point])
            {
              if (is_new || tasks.back().points.size() == most_points)
                tasks.push_back({group, {}});
              is_new = false;
              tasks.back().points.push_back(point);
            }
      }
    return tasks;
  }



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
    row.work    = std::exchange(work, {});
    return row;
  }



  SweepComputation::Computed
  SweepComputation::compute(const std::size_t group, const SweepPoint &point)
  {
    const Parameters &parameters = point.parameters;
    if (parameters.adaptivity.is_adaptive() &&
        parameters.sweep.adapts_each_point)
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
    const Warnings       warnings =
      impact_warnings(computed,
                      parameters.adaptivity.is_adaptive() ? nullptr : &mesh);
    return {std::move(result), warnings.all()};
  }



  std::unique_ptr<Triangulation<2>>
  SweepComputation::make_mesh(const std::size_t group, const SweepPoint &point)
  {
    ++work.meshes;
    if (!point.parameters.adaptivity.is_adaptive())
      return make_plate_mesh(point.parameters.plate,
                             point.parameters.discretization.initial_cells);
    std::optional<SweepPoint> worst;
    const auto                severity = [](const SweepPoint &point) {
      return std::make_tuple(-point.expected.peak.time,
                             point.expected.peak.force);
    };
    for (const std::size_t index : groups.groups[group])
      try
        {
          const SweepPoint other = scene.point(index);
          if (!worst || severity(other) > severity(*worst))
            worst = other;
        }
      catch (const InputError &)
        {
          // it gets its row when its turn comes
        }
    ImpactAnalysis analysis(worst->parameters);
    analysis.run();
    mesh_warnings           = analysis.warnings;
    const CycleResult &last = analysis.last_cycle().result;
    work.meshes += last.cycle - 1;
    if (const std::string warning =
          Goal(worst->parameters.adaptivity).warning(last);
        !warning.empty())
      mesh_warnings.push_back(
        "on the mesh adapted for the point with the shortest contact, " +
        warning);
    return copy_of(analysis.last_cycle().mesh());
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
