#include "plate_impact/analysis/impact_quantities.h"

#include "plate_impact/contact/contact_area.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/plate_section.h"

namespace PlateImpact
{
  std::optional<double>
  restitution(const ContactHistory &history)
  {
    const ContactState &first = history.states().front(),
                       &last  = history.states().back();
    if (history.n_contacts() == 0 || last.overlap() > 0. ||
        last.impactor_velocity > 0.)
      return {};
    return -last.impactor_velocity / first.impactor_velocity;
  }



  const std::vector<ImpactQuantity> &
  impact_quantities()
  {
    static const std::vector<ImpactQuantity> quantities = {
      {"peak_force", "Peak force", "N"},
      {"time_of_peak_force", "Time of the peak force", "s"},
      {"first_contact_end", "End of the first contact", "s"},
      {"number_of_contacts", "Number of contacts", ""},
      {"impulse", "Impulse", "N s"},
      {"final_impactor_velocity", "Final velocity of the impactor", "m/s"},
      {"max_plate_displacement", "Largest displacement of the plate", "m"},
      {"contact_radius_over_thickness",
       "Largest contact radius over the thickness",
       ""},
      {"relative_energy_drift", "Relative drift of the energy", ""},
      {"coefficient_of_restitution", "Coefficient of restitution", ""},
      {"plate_energy_fraction", "Energy left in the plate, fraction", ""},
      {"zener_loss_factor", "Loss factor of Zener's formula", ""},
      {"peak_force_over_zener", "Peak force over Zener's", ""},
      {"restitution_over_zener", "Restitution over Zener's", ""},
      {"discretization_error",
       "Relative error in the energy norm eta, fraction",
       ""},
      {"peak_force_error_bar", "Error bar of the peak force, fraction", ""}};
    return quantities;
  }



  std::vector<std::optional<double>>
  values_of_quantities(const Impact                &impact,
                       const Parameters            &parameters,
                       const ExpectedPeak          &expected,
                       const std::optional<double> &discretization_error,
                       const std::optional<double> &peak_force_bar)
  {
    const ContactHistory &history = impact.history;
    const ContactState &peak = history.peak(), &last = history.states().back();
    const std::optional<double> e = restitution(history);

    std::optional<double> loss_factor, peak_over_zener, e_over_zener;
    if (!parameters.impactor.is_cylinder())
      {
        const Contact      contact  = make_half_space_contact(parameters);
        const Impactor     impactor = make_impactor(parameters.impactor);
        const PlateSection section(parameters.plate);
        loss_factor          = zener_loss_factor(contact, impactor, section);
        peak_over_zener      = peak.force / expected.force;
        const double zener_e = zener_restitution(contact, impactor, section);
        if (e && history.n_contacts() == 1 && zener_e > 0.)
          e_over_zener = *e / zener_e;
      }
    return {peak.force,
            peak.time,
            history.first_contact_end(),
            history.n_contacts(),
            impact.impulse,
            last.impactor_velocity,
            history.max_plate_displacement(),
            contact_radius(parameters, peak.force, peak.indentation) /
              parameters.plate.thickness,
            history.relative_energy_drift(),
            e,
            last.plate_energy / history.states().front().total_energy(),
            loss_factor,
            peak_over_zener,
            e_over_zener,
            discretization_error,
            peak_force_bar};
  }
} // namespace PlateImpact
