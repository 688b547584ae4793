#include "plate_impact/analysis/work.h"

namespace PlateImpact
{
  Seconds &
  Seconds::operator+=(const Seconds &other)
  {
    mesh += other.mesh;
    assembly += other.assembly;
    factorization += other.factorization;
    stepping += other.stepping;
    estimation += other.estimation;
    output += other.output;
    return *this;
  }
} // namespace PlateImpact
