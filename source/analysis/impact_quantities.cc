#include "plate_impact/analysis/impact_quantities.h"

#include "plate_impact/analysis/delamination.h"

namespace PlateImpact
{
  namespace
  {
    using Value = std::optional<double>;

    const ContactState &
    first(const ComputedImpact &impact)
    {
      return impact.history.states().front();
    }



    const ContactState &
    peak(const ComputedImpact &impact)
    {
      return impact.history.peak();
    }



    const ContactState &
    last(const ComputedImpact &impact)
    {
      return impact.history.states().back();
    }



    bool
    has_yielded(const ComputedImpact &impact)
    {
      const Value &first = impact.bodies.yield_indentation;
      return first && peak(impact).indentation > *first;
    }



    /// Of a contact that stays elastic.
    Value
    contact_pressure(const ComputedImpact &impact)
    {
      if (peak(impact).force == 0. || has_yielded(impact))
        return {};
      return impact.bodies.elastic_pressure(peak(impact).force,
                                            peak(impact).indentation);
    }



    Value
    pressure_over_strength(const ComputedImpact &impact)
    {
      const auto &weaker = impact.bodies.weaker;
      if (!weaker || peak(impact).force == 0.)
        return {};
      return impact.bodies.mean_pressure(peak(impact).force,
                                         peak(impact).indentation) /
        weaker->yield_strength;
    }



    /// Of a contact that leaves a dent.
    Value
    if_dented(const ComputedImpact &impact, const double value)
    {
      if (impact.parameters.contact.unloading == UnloadingLaw::elastic &&
          !impact.bodies.yield_indentation)
        return {};
      return value;
    }



    Value
    delamination_threshold(const ComputedImpact &impact)
    {
      const auto crack =
        delamination(impact.parameters, impact.expected, peak(impact));
      return crack ? Value(crack->threshold) : Value();
    }



    Value
    restitution(const ComputedImpact &impact)
    {
      if (impact.history.n_contacts() == 0 || last(impact).overlap() > 0. ||
          last(impact).impactor_velocity > 0.)
        return {};
      return -last(impact).impactor_velocity / first(impact).impactor_velocity;
    }



    bool
    is_sphere(const ComputedImpact &impact)
    {
      return !impact.parameters.impactor.is_cylinder();
    }



    Value
    restitution_over_zener(const ComputedImpact &impact)
    {
      const Value e = restitution(impact);
      if (!is_sphere(impact) || !e || impact.history.n_contacts() != 1)
        return {};
      const double of_zener = impact.expected.restitution();
      return of_zener > 0. ? Value(*e / of_zener) : Value();
    }
  } // namespace



  const std::vector<ImpactQuantity> &
  impact_quantities()
  {
    using Impact = const ComputedImpact &;
    static const std::vector<ImpactQuantity> quantities = {
      {"peak_force",
       "Peak force",
       "N",
       [](Impact i) -> Value { return peak(i).force; }},
      {"time_of_peak_force",
       "Time of the peak force",
       "s",
       [](Impact i) -> Value { return peak(i).time; }},
      {"first_contact_end",
       "End of the first contact",
       "s",
       [](Impact i) { return i.history.first_contact_end(); }},
      {"number_of_contacts",
       "Number of contacts",
       "",
       [](Impact i) -> Value { return i.history.n_contacts(); }},
      {"impulse",
       "Impulse",
       "N s",
       [](Impact i) -> Value { return i.impulse; }},
      {"final_impactor_velocity",
       "Final velocity of the impactor",
       "m/s",
       [](Impact i) -> Value { return last(i).impactor_velocity; }},
      {"max_plate_displacement",
       "Largest displacement of the plate",
       "m",
       [](Impact i) -> Value { return i.history.max_plate_displacement(); }},
      {"contact_radius_over_thickness",
       "Largest contact radius over the thickness",
       "",
       [](Impact i) -> Value {
         return i.bodies.radius(peak(i).force, peak(i).indentation) /
           i.parameters.plate.thickness;
       }},
      {"relative_energy_drift",
       "Relative drift of the energy",
       "",
       [](Impact i) -> Value { return i.history.relative_energy_drift(); }},
      {"coefficient_of_restitution",
       "Coefficient of restitution",
       "",
       restitution},
      {"plate_energy_fraction",
       "Energy left in the plate, fraction",
       "",
       [](Impact i) -> Value {
         return last(i).plate_energy / first(i).total_energy();
       }},
      {"zener_loss_factor",
       "Loss factor of Zener's formula",
       "",
       [](Impact i) {
         return is_sphere(i) ? i.expected.loss_factor() : Value();
       }},
      {"peak_force_over_zener",
       "Peak force over Zener's",
       "",
       [](Impact i) {
         return is_sphere(i) ? peak(i).force / i.expected.peak.force : Value();
       }},
      {"restitution_over_zener",
       "Restitution over Zener's",
       "",
       restitution_over_zener},
      {"discretization_error",
       "Relative error in the energy norm eta, fraction",
       "",
       [](Impact i) { return i.discretization_error; }},
      {"peak_force_error_bar",
       "Error bar of the peak force, fraction",
       "",
       [](Impact i) { return i.peak_force_bar; }},
      {"contact_pressure", "Largest contact pressure", "Pa", contact_pressure},
      {"mean_pressure_over_yield_strength",
       "Mean contact pressure over the yield strength",
       "",
       pressure_over_strength},
      {"permanent_indentation",
       "Dent",
       "m",
       [](Impact i) { return if_dented(i, last(i).permanent_indentation); }},
      {"dissipated_energy",
       "Energy dissipated by the contact",
       "J",
       [](Impact i) { return if_dented(i, last(i).dissipated_energy); }},
      {"plate_dissipated_energy",
       "Energy dissipated by the plate",
       "J",
       [](Impact i) -> Value {
         const double energy = last(i).plate_dissipated_energy;
         return energy > 0. ? Value(energy) : Value();
       }},
      {"delamination_threshold",
       "Force from which on a laminate delaminates",
       "N",
       delamination_threshold},
      {"peak_force_over_delamination_threshold",
       "Peak force over that of delamination",
       "",
       [](Impact i) -> Value {
         const Value threshold = delamination_threshold(i);
         return threshold ? Value(peak(i).force / *threshold) : Value();
       }}};
    return quantities;
  }
} // namespace PlateImpact
