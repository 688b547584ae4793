#include "plate_impact/analysis/peak_force_bar.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// Of the force: beyond, a first order estimate on a first mesh says
    /// nothing.
    constexpr double largest_on_first_mesh = 0.05;
  } // namespace



  double
  PeakForceBar::total() const
  {
    return space + time + vectors;
  }



  double
  bar_of_mesh(const PeakForceError &estimate)
  {
    return safety_of_bar * estimate.sum_of_absolutes();
  }



  std::optional<double>
  peak_force_error_by_mesh(const PeakForceError            &estimate,
                           const double                     peak,
                           const std::optional<PeakOnMesh> &before,
                           const bool                       resolves_load)
  {
    if (!before &&
        (!resolves_load || estimate.sum_of_absolutes() > largest_on_first_mesh))
      return {};
    const double bar = bar_of_mesh(estimate);
    if (resolves_load)
      return bar;
    const double change    = std::abs(peak - before->force) / peak;
    const bool   was_blind = !before->space || change > *before->space;
    return std::max(bar, was_blind ? change : 0.);
  }



  ErrorOverLimit
  error_over_limit(const PeakForceError &estimate, const double target)
  {
    ErrorOverLimit result;
    const double   share = target / (safety_of_bar * estimate.cells.size());
    result.overall       = bar_of_mesh(estimate) / target;
    result.element_limit = std::sqrt(share);
    for (const double cell : estimate.cells)
      result.elements.push_back(std::sqrt(std::abs(cell) / share));
    return result;
  }
} // namespace PlateImpact
