#ifndef plate_impact_estimator_error_over_limit_h
#define plate_impact_estimator_error_over_limit_h

#include "plate_impact/estimator/error_estimator.h"

#include <vector>

namespace PlateImpact
{
  /// Errors by what a target allows of them (Table 1 of the paper): every cell
  /// may have the same share of the target,
  ///   e_m = target (||u||^2 + ||e||^2)^{1/2} / n^{1/2},
  /// so that the target is met when all cells keep to it. n is the number of
  /// cells that count, e_m their limit and that of singular ones.
  struct ErrorOverLimit
  {
    double overall       = 0.; ///< eta / target
    double element_limit = 0.; ///< e_m / (||u||^2 + ||e||^2)^{1/2}
    /// xi' = 1/T int ||e||_i / e_m dt, by active index.
    std::vector<double> elements;

    double
    max_element() const;
  };

  ErrorOverLimit
  error_over_limit(const ErrorEstimate &estimate, double target_error);
} // namespace PlateImpact

#endif
