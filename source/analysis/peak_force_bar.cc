#include "plate_impact/analysis/peak_force_bar.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// Covers the true errors on all meshes of doc/theory.md that are not
    /// blind.
    constexpr double safety = 2.;

    /// Of the force: beyond, a first order estimate on a first mesh says
    /// nothing.
    constexpr double largest_on_first_mesh = 0.05;
  } // namespace



  double
  PeakForceBar::total() const
  {
    return space + time + vectors;
  }



  std::optional<double>
  peak_force_error_by_mesh(const PeakForceError            &estimate,
                           const double                     peak,
                           const std::optional<PeakOnMesh> &before,
                           const bool                       resolves_load)
  {
    const double absolutes = estimate.sum_of_absolutes();
    if (!before)
      return !resolves_load || absolutes > largest_on_first_mesh ?
        std::nullopt :
        std::optional(safety * absolutes);
    const double change    = std::abs(peak - before->force) / peak;
    const bool   was_blind = !before->space || change > *before->space;
    return std::max(safety * absolutes, was_blind ? change : 0.);
  }



  ErrorOverLimit
  error_over_limit(const PeakForceError &estimate, const double target)
  {
    ErrorOverLimit result;
    const double   share = target / (safety * estimate.cells.size());
    result.overall       = safety * estimate.sum_of_absolutes() / target;
    result.element_limit = std::sqrt(share);
    for (const double cell : estimate.cells)
      result.elements.push_back(std::sqrt(std::abs(cell) / share));
    return result;
  }
} // namespace PlateImpact
