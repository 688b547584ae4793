#include "plate_impact/analysis/goal.h"

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/base/text.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <fmt/format.h>

namespace PlateImpact
{
  template <>
  const std::vector<Word<Outcome>> Choices<Outcome>::words = {
    {Outcome::single_mesh, "single mesh"},
    {Outcome::target_reached, "target reached"},
    {Outcome::maximum_cycles, "maximum cycles"},
    {Outcome::maximum_cells, "maximum cells"},
    {Outcome::mesh_unchanged, "mesh unchanged"},
    {Outcome::time_step_too_coarse, "time step too coarse"},
    {Outcome::not_verified, "not verified"},
    {Outcome::time_budget, "time budget"},
    {Outcome::minimum_cell_size, "minimum cell size"},
    {Outcome::nearly_as_fine_as_the_reference,
     "nearly as fine as the reference"}};



  namespace
  {
    /// Ratios by which the largest cells are halved, until all are equal, and
    /// then all. The order stays, by which some strategies choose.
    void
    halve_largest(const dealii::Triangulation<2> &mesh,
                  const double                    size_exponent,
                  ErrorRatios                    &ratios)
    {
      double sum = 0., area = 0.;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          sum += cell->measure() * cell_size(cell);
          area += cell->measure();
        }
      ratios.overall = std::exp2(1. / size_exponent);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          double      &ratio = ratios.elements[cell->active_cell_index()];
          const double size  = sum / area * (0.5 + 0.2 / (1. + ratio));
          ratio =
            std::clamp(std::pow(cell_size(cell) / size, 1. / size_exponent),
                       1. / 3.,
                       ratios.overall);
        }
    }



    /// As many equal cells as an error that is this factor smaller needs, but
    /// no fewer along a side and no more than halved ones; zeros where a mesh
    /// may not have them, or they would be below the minimum cell size.
    std::array<unsigned int, 2>
    equal_cells(const Cycle &cycle, const double factor)
    {
      if (!may_have_equal_cells(cycle.parameters))
        return {};
      auto         longest = longest_extents(cycle.mesh());
      const double size    = std::max(longest[0], longest[1]) /
        std::clamp(std::sqrt(growth_for_late_peak(factor / aim_for_late_peak)),
                   1.1,
                   2.);
      if (size < cycle.parameters.adaptivity.minimum_cell_size)
        return {};
      for (double &length : longest)
        length = std::min(length, size);
      return n_cells_of_size(cycle.parameters.plate, longest);
    }
  } // namespace



  /// Of the peak force every cell may have the same share of the target. The
  /// ratio is that of the roots, which fall with the cell size as errors in the
  /// energy norm do.
  ErrorRatios
  AdaptationControl::error_ratios(const Cycle &cycle) const
  {
    if (marking)
      return marking(cycle);
    const CycleResult &result = cycle.result;
    if (!is_for_peak)
      {
        ErrorRatios ratios = result.error->ratios(target);
        if (result.waves_are_everywhere)
          equalize(cycle.mesh(), ratios, adaptivity);
        return ratios;
      }
    const double bar = error(result);
    // What the time step leaves to the mesh, but a tenth of what there is at
    // most: estimates on coarse meshes do not tell more.
    const double for_mesh = std::max(
      {0.5 * target, target - result.time_error.value_or(0.), 0.1 * bar});
    const Eigen::VectorXd &cells = result.peak_force_error->cells;
    // waves that have come back add up to less than their contributions
    const double share = for_mesh / bar * cells.lpNorm<1>() / cells.size();
    ErrorRatios  ratios{bar / for_mesh, std::sqrt(share), {}};
    // Near the target no cell grows: the estimate knows nothing of the waves
    // that a coarser mesh turns back after the window.
    const double near_target = 3.,
                 least = ratios.overall < near_target ? 1. / near_target : 0.;
    for (const double cell : cells)
      ratios.elements.push_back(
        std::max(least, std::sqrt(std::abs(cell) / share)));
    const double halving = std::exp2(1. / adaptivity.size_exponent);
    // Waves that have come back many times are everywhere, and the largest
    // cells disperse them most.
    if (result.waves_are_everywhere)
      {
        ratios.equal_cells = equal_cells(cycle, ratios.overall);
        halve_largest(cycle.mesh(), adaptivity.size_exponent, ratios);
      }
    // Where there is no bar the mesh hides the load, or the waves that it sends
    // out, from the estimate: cells are halved once, whatever that says.
    if (!result.peak_force_bar && result.time_error)
      {
        for (const auto &cell : cycle.mesh().active_cell_iterators())
          if (is_near_load(cell,
                           cycle.parameters.impactor.contact_half_length()))
            {
              double &ratio = ratios.elements[cell->active_cell_index()];
              ratio         = std::max(ratio, halving);
            }
        ratios.overall = std::max(ratios.overall, halving);
      }
    return ratios;
  }



  std::optional<Outcome>
  AdaptationControl::outcome(const CycleResult &result) const
  {
    const unsigned int n_exempt =
      adaptivity.singular_cells_count ? 0 : result.cells_at_minimum_size;
    if (is_met(result) &&
        (is_for_peak ||
         (result.cells_above_limit == n_exempt && !result.is_uneven)))
      return Outcome::target_reached;
    // the mesh may have half of the target in any case
    if (is_for_peak && result.peak_force_bar &&
        result.peak_force_bar->space <= 0.5 * adaptivity.target())
      return Outcome::time_step_too_coarse;
    return {};
  }



  std::string
  AdaptationControl::warning(const CycleResult &result) const
  {
    const std::string target = about_percentage(adaptivity.target());
    if (is_for_peak)
      return is_met(result) ?
        "" :
        fmt::format(
          "the error bar of the peak force is {}: Adaptivity/Target peak force "
          "error, {}, is not met; choose {}, or a larger target",
          result.peak_force_bar ?
            about_percentage(result.peak_force_bar->total()) :
            "not known",
          target,
          adaptivity.is_adaptive() ?
            "more Maximum cycles, a smaller Time step or Minimum cell size" :
            "smaller cells, a smaller Time step");
    if (!result.error)
      return {};
    const std::string eta = about_percentage(result.error->eta);
    if (!is_met(result) && !adaptivity.is_adaptive())
      return "eta is " + eta +
        " on this mesh, more than Adaptivity/Target error, " + target +
        "; choose Adaptivity/Strategy = hanging nodes or more Initial cells";
    if (!is_met(result))
      return "eta is still " + eta + ": Adaptivity/Target error, " + target +
        ", is not met; choose more Maximum cycles, a smaller Minimum cell "
        "size or a larger target";
    if (adaptivity.is_adaptive() && !outcome(result))
      return result.cells_above_limit == 0 ?
        "eta meets Adaptivity/Target error, but cells are too large for waves "
        "that come back before the peak; choose more Maximum cycles" :
        fmt::format(
          "eta meets Adaptivity/Target error, but xi' is at least 1 in {} and "
          "reaches {}; choose more Maximum cycles or a smaller Minimum cell "
          "size",
          counted(result.cells_above_limit, "cell"),
          about(result.error_ratios->max_element()));
    return {};
  }
} // namespace PlateImpact
