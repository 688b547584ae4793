#include "plate_impact/command/expectation.h"

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/interrupt.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/plate_model.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// On a uniform mesh of the best element.
    PlateModel
    coarse_plate(const Parameters                  &parameters,
                 const std::array<unsigned int, 2> &n_cells)
    {
      DiscretizationParameters discretization = parameters.discretization;
      discretization.element                  = ElementType::MITC9;
      return {parameters.plate,
              discretization,
              make_plate_mesh(parameters.plate, n_cells)};
    }



    /// The impact on a coarse mesh, in steps of 1/64 of the contact, up to its
    /// end: where the contact outlasts what Zener's equation expects, end and
    /// step are extended together.
    CycleResult
    coarse_impact(const Parameters &scene,
                  const double      expected_contact_time,
                  const double      wavelength)
    {
      std::array<unsigned int, 2> n_cells  = {{8, 8}};
      const auto                  geometry = geometry_of(scene.plate);
      // Zener's equation, which gives short waves, is of no help for a cylinder
      for (unsigned int d = 0; d < 2; ++d)
        if (scene.impactor.is_cylinder())
          n_cells[d] = static_cast<unsigned int>(
            std::clamp(2. * (geometry.end[d] - geometry.begin[d]) / wavelength +
                         1.,
                       8.,
                       32.));
      Parameters parameters      = scene;
      parameters.time.integrator = IntegratorType::Ritz_vectors;
      parameters.time.end_time   = 1.5 * expected_contact_time;
      PlateModel  plate          = coarse_plate(parameters, n_cells);
      CycleResult result;
      const bool  is_held  = std::isfinite(plate.static_compliance(scene));
      result.cells         = plate.discretization().mesh().n_active_cells();
      result.min_cell_size = smallest_cell_size(plate.discretization().mesh());
      while (true)
        {
          parameters.time.time_step = parameters.time.end_time / 96.;
          result.history = plate.under(parameters, false).strike().history;
          const bool is_long =
            parameters.time.end_time > 1e6 * expected_contact_time;
          if (result.history->end_of_impact(is_held) || is_long)
            return result;
          parameters.time.end_time *= 2.;
        }
    }



    /// By which the bar of the peak force falls when every cell is halved: the
    /// median of random heavy impactors, whose peaks are late
    /// (doc/make/error_bars.py).
    constexpr double fall_by_halved_cells = 9.;



    /// The run itself, on its first two meshes: eta falls about as the number
    /// of cells grows, and the bar of the force as if every cell were halved,
    /// which only late peaks need.
    Expectation::Cost
    cost_by_two_meshes(Parameters parameters)
    {
      const bool has_more = parameters.adaptivity.maximum_cycles > 2;
      parameters.adaptivity.maximum_cycles =
        std::min(2u, parameters.adaptivity.maximum_cycles);
      ImpactAnalysis    analysis(parameters, nullptr, Wanted{true, false, 0});
      AdaptationControl control(parameters.adaptivity);
      AnalysisListener  listener;
      listener.step = [](const auto &...) { throw_if_interrupted(); };
      analysis.run(control, listener);
      const CycleResult          &result     = analysis.last_cycle().result;
      const AdaptivityParameters &adaptivity = parameters.adaptivity;
      double                      cells      = result.cells;
      if (!has_more)
        return {cells, 1. * result.steps};
      if (!adaptivity.is_for_peak_force())
        cells *= std::max(1., result.error->eta / adaptivity.target_error);
      else if (result.peak_force_bar &&
               result.peak_force_bar->total() >
                 adaptivity.target_peak_force_error)
        cells *=
          std::pow(4., // once at least
                   std::max(1.,
                            std::log(result.peak_force_bar->total() /
                                     adaptivity.target_peak_force_error) /
                              std::log(fall_by_halved_cells)));
      return {std::min(cells, 1. * adaptivity.maximum_cells),
              1. * result.steps};
    }
  } // namespace



  std::vector<double>
  expected_frequencies(const Parameters &parameters)
  {
    return coarse_plate(parameters, {{8, 8}}).natural_frequencies(4);
  }



  double
  distance_to_edge(const Parameters &parameters)
  {
    const auto   geometry = geometry_of(parameters.plate);
    const double patch    = parameters.contact.patch_radius;
    const double along_x  = parameters.contact.load_has_length() ?
       0.5 * parameters.impactor.length :
       patch;
    return std::max(0.,
                    std::min(geometry.distance_along[0] - along_x,
                             geometry.distance_along[1] -
                               (parameters.contact.load_is_line() ? 0. :
                                                                    patch)));
  }



  Expectation::Expectation(const Parameters &parameters)
    : zener(make_zener_impact(parameters))
  {
    const BendingWave wave = zener.wave();
    CycleResult       impact =
      coarse_impact(parameters, zener.contact_time(), wave.length);
    const bool is_resolved = impact.min_cell_size < 0.5 * wave.length;
    until                  = impact.history->states().back().time;
    contact_end            = impact.history->end_of_impact(/*is_held=*/true);
    if (!contact_end)
      contact_end = impact.history->first_contact_end();
    source = "on a coarse mesh of " + counted(impact.cells, "cell");
    if (!is_resolved)
      {
        // when waves are back from the edges
        until       = 2. * distance_to_edge(parameters) / wave.group_speed;
        contact_end = zener.history(until).first_contact_end();
        source =
          "for an infinite plate, since the waves are too short for a coarse "
          "mesh";
        impact.history =
          zener.history(parameters.time.end_time > 0. ?
                          std::min(until, parameters.time.end_time) :
                          until);
      }
    is_bound             = parameters.impactor.is_cylinder() && !is_resolved;
    history              = *impact.history;
    impact.min_cell_size = parameters.adaptivity.minimum_cell_size;
    if (!is_bound)
      {
        const Warnings of_model = model_warnings({parameters, zener, impact});
        warnings                = of_model.all();
        contact                 = of_model.contact;
      }
  }



  std::optional<double>
  Expectation::crossings_before_peak(const Parameters &parameters) const
  {
    const double crossings = history.peak().time *
      zener.section.fastest_wave() / (2. * distance_to_edge(parameters));
    return crossings > 5. ? std::optional<double>(crossings) : std::nullopt;
  }



  Expectation::Cost
  Expectation::cost(const Parameters &parameters) const
  {
    if (parameters.adaptivity.is_adaptive())
      return cost_by_two_meshes(parameters);
    const TimeParameters &time = parameters.time;
    const double          end =
      time.end_time > 0. ? time.end_time : contact_end.value_or(until);
    return {n_initial_cells(parameters), end / time.time_step};
  }
} // namespace PlateImpact
