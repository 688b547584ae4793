#include "plate_impact/analysis/impact_quantities.h"

#include "plate_impact/plate/plate_geometry.h"

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    using Value    = std::optional<double>;
    using Computed = const ComputedImpact &;

    /// Of a contact that leaves a dent.
    Value
    if_dented(const ComputedImpact &impact, const double value)
    {
      if (impact.contact.unloading == UnloadingLaw::elastic &&
          !impact.bodies.yield_indentation)
        return {};
      return value;
    }



    Value
    restitution(const ComputedImpact &impact)
    {
      if (impact.history.n_contacts() == 0 || impact.last.overlap() > 0. ||
          impact.last.impactor_velocity > 0.)
        return {};
      return -impact.last.impactor_velocity / impact.first.impactor_velocity;
    }
  } // namespace



  const std::vector<ImpactQuantity> impact_quantities = {
    {{"peak_force", "Peak force", "N"},
     [](Computed i) -> Value { return i.peak.force; }},
    {{"time_of_peak_force", "Time of the peak force", "s"},
     [](Computed i) -> Value { return i.peak.time; }},
    {{"first_contact_end", "End of the first contact", "s"},
     [](Computed i) { return i.history.end_of_impact(); }},
    {{"number_of_contacts", "Number of contacts"},
     [](Computed i) -> Value { return i.history.n_contacts(); }},
    {{"impulse", "Impulse", "N s"},
     [](Computed i) -> Value { return i.result.impulse; }},
    {{"final_impactor_velocity", "Final velocity of the impactor", "m/s"},
     [](Computed i) -> Value { return i.last.impactor_velocity; }},
    {{"max_plate_displacement", "Largest displacement of the plate", "m"},
     [](Computed i) -> Value { return i.history.max_plate_displacement(); }},
    {{"contact_radius_over_thickness",
      "Largest contact radius over the thickness"},
     [](Computed i) -> Value {
       return i.bodies.radius(i.peak.force, i.peak.indentation) /
         i.plate.thickness;
     }},
    {{"relative_energy_drift", "Relative drift of the energy"},
     [](Computed i) -> Value { return i.history.relative_energy_drift(); }},
    {{"coefficient_of_restitution", "Coefficient of restitution"}, restitution},
    {{"plate_energy_fraction", "Energy left in the plate, fraction"},
     [](Computed i) -> Value {
       return i.last.plate_energy / i.first.total_energy();
     }},
    {{"zener_loss_factor", "Loss factor of Zener's formula"},
     [](Computed i) {
       return i.impactor.is_cylinder() ? Value() : i.expected.loss_factor();
     }},
    {{"peak_force_over_zener", "Peak force over Zener's"},
     [](Computed i) {
       return i.impactor.is_cylinder() ? Value() :
                                         i.peak.force / i.expected.peak.force;
     }},
    {{"restitution_over_zener", "Restitution over Zener's"},
     [](Computed i) -> Value {
       const Value e = restitution(i);
       if (i.impactor.is_cylinder() || !e || i.history.n_contacts() != 1)
         return {};
       const double of_zener = i.expected.restitution();
       return of_zener > 0. ? *e / of_zener : Value();
     }},
    {{"discretization_error",
      "Relative error in the energy norm eta, fraction"},
     [](Computed i) {
       return i.result.error ? Value(i.result.error->eta) : Value();
     }},
    {{"peak_force_error_bar", "Error bar of the peak force, fraction"},
     [](Computed i) {
       const auto &bar = i.result.peak_force_bar;
       return bar ? Value(bar->total()) : Value();
     }},
    // of a contact that stays elastic
    {{"contact_pressure", "Largest contact pressure", "Pa"},
     [](Computed i) -> Value {
       const Value &first_yield = i.bodies.yield_indentation;
       if (i.peak.force == 0. ||
           (first_yield && i.peak.indentation > *first_yield))
         return {};
       return i.bodies.elastic_pressure(i.peak.force, i.peak.indentation);
     }},
    {{"mean_pressure_over_yield_strength",
      "Mean contact pressure over the yield strength"},
     [](Computed i) -> Value {
       if (!i.bodies.weaker || i.peak.force == 0.)
         return {};
       return i.bodies.mean_pressure(i.peak.force, i.peak.indentation) /
         i.bodies.weaker->yield_strength;
     }},
    {{"permanent_indentation", "Dent", "m"},
     [](Computed i) { return if_dented(i, i.last.permanent_indentation); }},
    {{"dissipated_energy", "Energy dissipated by the contact", "J"},
     [](Computed i) { return if_dented(i, i.last.dissipated_energy); }},
    {{"plate_dissipated_energy", "Energy dissipated by the plate", "J"},
     [](Computed i) -> Value {
       const double energy = i.last.plate_dissipated_energy;
       return energy > 0. ? Value(energy) : Value();
     }},
    {{"delamination_threshold", "Delamination threshold", "N"},
     [](Computed i) {
       const auto crack = delamination(i);
       return crack ? Value(crack->threshold) : Value();
     }},
    {{"peak_force_over_delamination_threshold",
      "Peak force over the delamination threshold"},
     [](Computed i) {
       const auto crack = delamination(i);
       return crack ? Value(i.peak.force / crack->threshold) : Value();
     }}};



  std::optional<Delamination>
  delamination(const ComputedImpact &impact)
  {
    const PlyParameters &ply = impact.plate.ply;
    if (!impact.plate.is_laminate() || ply.mode_2_toughness == 0. ||
        impact.peak.force <= 0.)
      return {};
    const double slow = std::acos(-1.) *
      std::sqrt(32. / 3. * impact.section.mean_bending_stiffness() *
                ply.mode_2_toughness);
    const double there_and_back = 2. *
      geometry_of(impact.plate).distance_to_edge /
      impact.expected.wave(2. * impact.peak.time).group_speed;
    const bool is_of_small_mass = impact.peak.time < there_and_back;
    return Delamination{is_of_small_mass ? 1.213 * slow : slow,
                        is_of_small_mass};
  }
} // namespace PlateImpact
