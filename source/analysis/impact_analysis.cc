#include "plate_impact/analysis/impact_analysis.h"

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  ImpactAnalysis::ImpactAnalysis(const Parameters                 &parameters,
                                 std::unique_ptr<Triangulation<2>> first_mesh,
                                 const std::optional<Wanted>      &wanted)
    : parameters(parameters)
    , wanted(wanted.value_or(Wanted{parameters.needs_estimator(),
                                    parameters.output.write_report,
                                    parameters.output.field_samples}))
    , time_control(
        parameters.has_impactor() ?
          std::make_optional<TimeControl>(parameters,
                                          make_zener_impact(parameters)) :
          std::nullopt)
    , mesh(std::move(first_mesh))
  {
    const Timer timer;
    this->parameters.adaptivity.singular_points.points =
      singular_points(parameters);
    if (mesh == nullptr)
      mesh =
        make_first_mesh(parameters, parameters.discretization.initial_cells);
    if (time_control)
      window = time_control->first();
    seconds_for_mesh = timer.wall_time();
  }



  Outcome
  ImpactAnalysis::run(AdaptationControl &control, AnalysisListener &listener)
  {
    while (true)
      {
        begin_cycle(listener);                         // unknowns on a mesh
        watch(listener);                               // plan, observe
        auto outcome = control.check(current->result); // decide
        if (!outcome)
          outcome = adapt(control, listener); // the next mesh
        if (outcome && time_control &&
            !time_control->is_whole(window, current->result))
          {
            window.extent = Extent::whole;
            current->result.peak_force_error.reset(); // of a shorter window
            observe(listener);
          }
        listener.cycle(*current); // tell
        if (outcome)
          return *outcome;
      }
  }



  void
  ImpactAnalysis::begin_cycle(AnalysisListener &listener)
  {
    listener.stage(n_cycles + 1, "matrices");
    before.reset();
    double seconds_before = 0.;
    if (current != nullptr)
      {
        const CycleResult &last = current->result;
        seconds_before          = last.cumulative_seconds();
        if (last.peak_force_error)
          before = PeakOnMesh{last.history->peak().force,
                              last.mesh_part_of_bar,
                              last.cells};
      }
    current.reset();
    current = std::make_unique<Cycle>(++n_cycles, parameters, std::move(mesh));
    current->result.seconds.mesh   = seconds_for_mesh;
    current->result.seconds_before = seconds_before;
    current->charge(&Seconds::assembly);
  }



  void
  ImpactAnalysis::watch(AnalysisListener &listener)
  {
    // a plate at rest stays at rest
    if (!time_control)
      return;
    for (std::optional<Window> next = window; next;)
      {
        window = *next;
        observe(listener);
        next = time_control->next(window, current->result);
        if (window.extent == Extent::peak_search &&
            time_control->returns_of_waves(*current->result.history) > 1.)
          refine_for_waves(listener);
      }
  }



  void
  ImpactAnalysis::refine_for_waves(AnalysisListener &listener)
  {
    const Timer timer;
    mesh = copy_of(current->mesh());
    // of a quadrant of 3 x 3 cells
    const auto           sides = geometry_of(parameters.plate).side_lengths;
    AdaptivityParameters adaptivity = parameters.adaptivity;
    adaptivity.maximum_cell_size =
      std::min(adaptivity.maximum_cell_size, std::max(sides[0], sides[1]) / 6.);
    const double anywhere = std::numeric_limits<double>::max();
    if (!refine_to_contact(*mesh, anywhere, adaptivity, 0.))
      return;
    // all that was before has made this first mesh
    seconds_for_mesh = current->result.seconds.total() + timer.wall_time();
    current.reset();
    --n_cycles;
    begin_cycle(listener);
  }



  void
  ImpactAnalysis::observe(AnalysisListener &listener)
  {
    current->charge(&Seconds::mesh); // of a next one that was not to be
    CycleResult &result = current->result;
    if (parameters.time.end_time == 0.)
      listener.stage(result.cycle, "end of the contact");
    Parameters impact =
      time_control->impact(window, current->plate, wanted.errors);
    if (window.extent != Extent::to_peak)
      window.whole = impact.time.end_time;
    if (result.degrees_of_freedom >= unknowns_in_vain &&
        NewmarkScheme(impact.time, impact.contact.integration).n_steps <=
          steps_in_vain)
      impact.time.integrator = IntegratorType::Newmark;
    if (window.extent == Extent::peak_search)
      result.history =
        current->plate.under(impact, wanted.errors).strike().history;
    current->charge(&Seconds::stepping);
    if (window.extent == Extent::peak_search)
      return;

    // of a window before, in longer steps: it costs as much as some transients
    const auto   known                 = result.peak_force_error;
    const double mesh_error            = result.mesh_error();
    static_cast<Observation &>(result) = current->observe(
      impact,
      wanted,
      [&](const Observation &seen) {
        return !known ||
          time_control->wanted_step(window, seen, mesh_error) == window.step;
      },
      listener);
    if (known && !result.peak_force_error)
      result.peak_force_error = known; // its judgement stays
    else
      static_cast<Judgement &>(result) = judgement();
    if (result.new_vectors > 0.7 * result.steps ||
        (result.new_vectors > 0 &&
         result.new_solves >= result.new_vectors + 0.5 * result.steps))
      {
        unknowns_in_vain = result.degrees_of_freedom / 2;
        steps_in_vain    = result.steps;
      }
    current->charge(&Seconds::estimation);
  }



  Judgement
  ImpactAnalysis::judgement() const
  {
    const CycleResult          &result     = current->result;
    const AdaptivityParameters &adaptivity = parameters.adaptivity;
    if (adaptivity.is_for_peak_force() && !result.peak_force_error)
      throw ComputationError("cycle " + std::to_string(result.cycle) +
                             ": the error of the peak force cannot be "
                             "estimated, because there is no force or its peak "
                             "comes after more than " +
                             std::to_string(int(most_steps_to_peak)) +
                             " steps; choose a larger Time/Time step, or "
                             "Adaptivity/Goal = energy norm");
    Judgement worth;
    worth.returns_of_waves = time_control->returns_of_waves(*result.history);
    worth.waves_are_everywhere =
      worth.returns_of_waves > 1. && result.history->peak_is_on_ripples();
    worth.mesh_part_of_bar = mesh_part_of_bar();
    if (worth.mesh_part_of_bar && result.time_error)
      worth.peak_force_bar =
        PeakForceBar{*worth.mesh_part_of_bar,
                     *result.time_error,
                     result.vector_error,
                     result.peak_force_error->on_softer_plate.has_value()};
    if (!result.error)
      return worth;
    worth.error_ratios = result.error->ratios(adaptivity.target_error);
    for (const auto &cell : current->mesh().active_cell_iterators())
      if (worth.error_ratios->elements[cell->active_cell_index()] >= 1.)
        {
          ++worth.cells_above_limit;
          if (is_smallest(cell, adaptivity))
            ++worth.cells_at_minimum_size;
        }
    ErrorRatios even = *worth.error_ratios;
    // of strategies that follow target sizes
    worth.is_uneven = worth.waves_are_everywhere &&
      (adaptivity.strategy == AdaptationStrategy::hanging_nodes ||
       adaptivity.strategy == AdaptationStrategy::remeshing) &&
      equalize(current->mesh(), even, adaptivity);
    return worth;
  }



  std::optional<double>
  ImpactAnalysis::mesh_part_of_bar() const
  {
    const CycleResult &result = current->result;
    if (!result.peak_force_error)
      return {};
    const ContactParameters &contact = parameters.contact;
    const double load = contact.has_patch() ? 2. * contact.patch_radius :
                                              parameters.plate.thickness;
    // nothing tells an error where the mesh does not see the waves that the
    // contact sends out
    if (result.cell_size_at_load >
        0.5 * std::max(time_control->expected.wave().length, 2. * load))
      return {};
    return peak_force_error_by_mesh(*result.peak_force_error,
                                    result.history->peak().force,
                                    before,
                                    result.cell_size_at_load <= load);
  }



  std::optional<Outcome>
  ImpactAnalysis::adapt(AdaptationControl &control, AnalysisListener &listener)
  {
    listener.stage(n_cycles, "next mesh");
    const AdaptivityParameters &adaptivity = parameters.adaptivity;
    const Timer                 timer;
    ErrorRatios                 error;
    do
      {
        error                 = control.error_ratios(*current);
        const auto [n_x, n_y] = error.equal_cells;
        const bool is_divided = n_x > 0;
        // before there is a mesh that does not fit into the memory
        if ((is_divided ? 1. * n_x * n_y :
                          n_wanted_cells(current->mesh(), error, adaptivity)) >
            adaptivity.maximum_cells)
          return Outcome::maximum_cells;
        // whoever keeps the last cycle needs its mesh: adapt a copy
        auto adapted = is_divided ?
          make_first_mesh(parameters, error.equal_cells) :
          copy_of(current->mesh());
        if (is_divided ||
            adapt_mesh({*adapted,
                        error,
                        adaptivity,
                        parameters.impactor.contact_half_length(),
                        warnings}))
          {
            if (adapted->n_active_cells() > adaptivity.maximum_cells)
              return Outcome::maximum_cells;
            if (time_control)
              window =
                time_control->with_peak(window, *current->result.history);
            mesh             = std::move(adapted);
            seconds_for_mesh = timer.wall_time();
            return {};
          }
    } while (control.tighten());
    return Outcome::mesh_unchanged;
  }



  void
  ImpactAnalysis::refine_everywhere()
  {
    const Timer timer;
    mesh = copy_of(current->mesh());
    mesh->refine_global();
    seconds_for_mesh = timer.wall_time();
  }



  void
  ImpactAnalysis::verify()
  {
    CycleResult &result = current->result;
    if (!result.history)
      return;
    const Timer timer;
    refine_everywhere();
    // no longer than the peak takes, with nothing but the force
    Parameters          to_peak = parameters;
    const NewmarkScheme scheme(result.time, parameters.contact.integration);
    to_peak.time                = result.time;
    to_peak.time.time_step      = scheme.dt;
    to_peak.time.end_of_vectors = 0.;
    to_peak.time.end_time =
      std::min(to_peak.time.end_time,
               scheme.dt *
                 std::ceil(1.1 * result.history->peak().time / scheme.dt));
    PlateModel   plate(to_peak.plate, to_peak.discretization, std::move(mesh));
    const Impact impact = plate.under(to_peak, false).strike();
    result.verification =
      PeakOnMesh{impact.history.peak().force,
                 {},
                 plate.discretization().mesh().n_active_cells()};
    const double change =
      std::abs(impact.history.peak().force / result.history->peak().force - 1.);
    // Nothing else tells the error of a plate with large deflections: twice
    // the change, as of an error that falls with the size of the cells.
    if (current->discretization().is_nonlinear() && result.time_error)
      result.peak_force_bar = PeakForceBar{2. * change, *result.time_error};
    // an error that is seen is part of the bar
    else if (auto &bar = result.peak_force_bar)
      bar->space = std::max(bar->space, change);
    result.seconds.estimation += timer.wall_time();
  }



  Warnings
  ImpactAnalysis::all_warnings() const
  {
    if (!time_control)
      return {};
    Parameters last_struck = parameters;
    last_struck.time       = current->result.time;
    Warnings all =
      impact_warnings({last_struck, time_control->expected, current->result},
                      &current->mesh());
    all.numerical.insert(all.numerical.end(), warnings.begin(), warnings.end());
    return all;
  }
} // namespace PlateImpact
