#include "plate_impact/estimator/error_over_limit.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  double
  ErrorOverLimit::max_element() const
  {
    return *std::max_element(elements.begin(), elements.end());
  }



  ErrorOverLimit
  error_over_limit(const ErrorEstimate &estimate, const double target_error)
  {
    // without cells that count the limit is that of one
    const std::size_t n_counted =
      estimate.element_errors.size() - estimate.n_singular_cells;
    ErrorOverLimit result;
    result.overall = estimate.eta / target_error;
    result.element_limit =
      target_error / std::sqrt(std::max<double>(1., n_counted));
    for (const double error : estimate.element_errors)
      result.elements.push_back(error / result.element_limit);
    return result;
  }
} // namespace PlateImpact
