#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_bodies.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/contact/zener.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// An impact that has been computed, with what its quantities come from; what
  /// it is made of must outlive it.
  struct ComputedImpact
  {
    const Parameters     &parameters;
    const ZenerImpact    &expected;
    const CycleResult    &result; ///< with a history
    const ContactHistory &history = *result.history;
    const ContactState   &first   = history.states.front();
    const ContactState   &peak    = history.peak();
    const ContactState   &last    = history.states.back();

    const PlateParameters      &plate      = parameters.plate;
    const ImpactorParameters   &impactor   = parameters.impactor;
    const ContactParameters    &contact    = parameters.contact;
    const TimeParameters       &time       = parameters.time;
    const AdaptivityParameters &adaptivity = parameters.adaptivity;
    const PlateSection         &section    = expected.section;
    const ContactBodies         bodies{parameters, section};
  };


  /// What a quantity is called.
  struct QuantityName
  {
    std::string name; ///< in summary.json and sweep.csv
    std::string title;
    std::string unit = ""; ///< of SI; empty: a pure number
  };

  /// A quantity that an engineer reads from an impact.
  struct ImpactQuantity : QuantityName
  {
    /// Empty where an impact has none: an end of the contact that lasts to the
    /// end time, a restitution while bodies still touch or approach, Zener's
    /// numbers for a cylinder, their deviations after several contacts.
    std::optional<double> (*value)(const ComputedImpact &impact);
  };


  /// All of them, in the order of the columns of sweep.csv.
  extern const std::vector<ImpactQuantity> impact_quantities;


  /// From which contact force on a laminate delaminates, by the energy that a
  /// round crack in its middle surface sets free however large it is:
  ///   P = pi sqrt(32 D* G_IIc / 3)
  /// (Davies & Zhang, Int. J. Impact Eng. 16, 1995, p. 149), with D* the mean
  /// bending stiffness (PlateSection). An impact whose peak comes before waves
  /// are back from an edge, one of a small mass, bears 1.213 of that (Olsson,
  /// Donadon & Falzon, Int. J. Solids Struct. 43, 2006, p. 3124).
  struct Delamination
  {
    double threshold; ///< [N]
    bool   is_of_small_mass;
  };

  /// @return empty for an isotropic plate, and where no toughness is given
  std::optional<Delamination>
  delamination(const ComputedImpact &impact);
} // namespace PlateImpact
