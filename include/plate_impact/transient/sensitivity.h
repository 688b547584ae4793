#ifndef plate_impact_transient_sensitivity_h
#define plate_impact_transient_sensitivity_h

#include "plate_impact/contact/contact_history.h"
#include "plate_impact/contact/impactor.h"

#include <functional>
#include <optional>

namespace PlateImpact
{
  /// How a force history answers to a change of the velocity by a millionth.
  /// One contact changes in proportion; a ball that bounces on a plate in
  /// motion may multiply the change with every contact, until nothing that
  /// follows is known, whatever the mesh and the step.
  struct Sensitivity
  {
    /// Largest change of the force, relative to the peak, over the relative
    /// change of the velocity: about 1 for a single contact.
    double factor = 0.;

    /// The first time at which the force changes by more than a thousandth of
    /// its peak; empty where it never does. [s]
    std::optional<double> unpredictable_from;
  };

  /// @param history  of the impactor
  /// @param strike   the history of another one on the same plate
  Sensitivity
  sensitivity_to_velocity(
    const ContactHistory                                  &history,
    const Impactor                                        &impactor,
    const std::function<ContactHistory(const Impactor &)> &strike);
} // namespace PlateImpact

#endif
