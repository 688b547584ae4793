#ifndef plate_impact_expectation_h
#define plate_impact_expectation_h

#include "plate_impact/scene.h"

#include <iosfwd>

namespace PlateImpact
{
  /// What to expect of a scene before paying for it: peak force and contact
  /// time of Zener's infinite thin plate (zener_peak), the force on a rigid
  /// plate as their upper bound, the time at which the first waves return from
  /// the edges, the bending wavelength of the contact against the cells, advice
  /// on the step, and a rough cost.
  void
  print_expectation(std::ostream &out, const Scene &scene);
} // namespace PlateImpact

#endif
