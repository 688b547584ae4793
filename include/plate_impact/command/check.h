#ifndef plate_impact_command_check_h
#define plate_impact_command_check_h

#include "plate_impact/scene/scene.h"

#include <iosfwd>

namespace PlateImpact
{
  /// What to expect of a scene before paying for it: peak force and contact
  /// time on a coarse mesh, which takes some hundredths of a second; beside
  /// them Zener's infinite thin plate (zener_peak) and the force on a plate
  /// that does not move; the time at which the first waves return from the
  /// edges, the bending wavelength of the contact against the cells, advice on
  /// step and end time, a rough cost, what a sweep of it computes, and where
  /// the impact leaves the model.
  /// @throws ComputationError when the impact cannot be computed
  void
  print_expectation(std::ostream &out, const Scene &scene);
} // namespace PlateImpact

#endif
