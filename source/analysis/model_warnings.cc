#include "plate_impact/analysis/model_warnings.h"

#include "plate_impact/base/text.h"
#include "plate_impact/contact/contact_area.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  namespace
  {
    /// Radius or half-width of Hertz's contact at the peak. [m]
    double
    radius_at(const Parameters &parameters, const ContactState &peak)
    {
      return contact_radius(parameters, peak.force, peak.indentation);
    }



    /// When the radius of the load on the plate is halved, the plate gives way
    /// by F ln 2 / (2 pi kappa G t) more under it; relative to the indentation.
    double
    give_per_halving(const PlateSection &section, const ContactState &peak)
    {
      const double pi = std::acos(-1.);
      return peak.force * std::log(2.) /
        (2. * pi * section.mean_shear_stiffness() * peak.indentation);
    }



    /// Relative drop of the peak force then, as if the contact were softer by
    /// as much.
    double
    drop_per_halving(const Parameters   &parameters,
                     const PlateSection &section,
                     const ContactState &peak)
    {
      // F = k alpha^{3/2}, k grows with the root of the radius
      const auto force = [&](const double factor_of_k) {
        Parameters changed = parameters;
        changed.impactor.radius *= factor_of_k * factor_of_k;
        return zener_peak(changed).force;
      };
      const double step     = 0.05;
      const double exponent = std::log(force(1. + step) / force(1. - step)) /
        std::log((1. + step) / (1. - step));
      return 1.5 * give_per_halving(section, peak) * exponent;
    }



    /// Notes a limit of the model, by how much it is passed.
    void
    leave_model(Warnings          &warnings,
                const double       over_limit,
                const std::string &sentence)
    {
      warnings.model.push_back(sentence);
      warnings.farthest_from_model =
        std::max(warnings.farthest_from_model, over_limit);
    }



    /// Load and reading with the rotations make plate and layer alike to waves
    /// long against the patch only: measured, the force of the main scene is
    /// 0.3 % too large with 1.5 thicknesses, 1.3 % with 3.
    void
    warn_of_layer_patch(const Parameters &parameters, Warnings &warnings)
    {
      const double ratio =
        parameters.contact.patch_radius / parameters.plate.thickness;
      if (ratio > 1.5)
        leave_model(
          warnings,
          ratio / 1.5,
          fmt::format("Contact/Patch radius = {} m is {} thicknesses of the "
                      "plate: beyond 1.5 it blurs the waves that the "
                      "contact sends out; choose Contact/Patch radius = 0",
                      about(parameters.contact.patch_radius),
                      about(ratio)));
    }



    void
    warn_of_strip(const Parameters &parameters,
                  const double      radius,
                  Warnings         &warnings)
    {
      const ContactParameters &contact = parameters.contact;
      const double             limit =
        std::max(2. * radius, 0.5 * parameters.plate.thickness);
      if (contact.has_patch() && contact.patch_radius > limit)
        leave_model(
          warnings,
          contact.patch_radius / limit,
          fmt::format("the force is spread over a strip of half-width {}, "
                      "but the contact is {} wide; choose Contact/Patch "
                      "radius = {}",
                      about(contact.patch_radius, "m"),
                      about(radius, "m"),
                      about(radius)));
    }



    void
    warn_of_point_load(const Parameters   &parameters,
                       const PlateSection &section,
                       const CycleResult  &result,
                       Warnings           &warnings)
    {
      const double drop =
        drop_per_halving(parameters, section, result.history->peak());
      if (drop >= 1e-4)
        warnings.numerical.push_back(
          fmt::format("the peak force under a point load has no limit: it "
                      "depends on the smallest cell, {}, and drops by about {} "
                      "per halving; for a limit choose Contact/Load "
                      "distribution = Hertz disc",
                      about(result.min_cell_size, "m"),
                      about_percentage(drop)));
    }



    void
    warn_of_disc(const Parameters   &parameters,
                 const PlateSection &section,
                 const ContactState &peak,
                 const double        radius,
                 Warnings           &warnings)
    {
      const ContactParameters &contact = parameters.contact;
      const double halvings = std::log2(contact.patch_radius / radius);
      // a force grows at most like k^{2/5}
      if (0.6 * give_per_halving(section, peak) * std::abs(halvings) < 0.005)
        return;
      const double change =
        drop_per_halving(parameters, section, peak) * halvings;
      if (std::abs(change) > 0.005)
        leave_model(
          warnings,
          std::abs(change) / 0.05,
          fmt::format("Contact/Patch radius = {} m spreads the force over "
                      "another area than the contact, whose radius is {}: "
                      "the peak force is {}{}{}; choose Contact/Patch "
                      "radius = {}",
                      about(contact.patch_radius),
                      about(radius, "m"),
                      contact.patch_radius > parameters.plate.thickness ?
                        "more than " :
                        "about ",
                      about_percentage(std::abs(change)),
                      change > 0. ? " too large" : " too small",
                      about(radius)));
    }



    void
    warn_of_load(const Parameters   &parameters,
                 const PlateSection &section,
                 const CycleResult  &result,
                 Warnings           &warnings)
    {
      const ContactState &peak = result.history->peak();
      if (peak.force <= 0.)
        return;
      const double radius = radius_at(parameters, peak);
      if (parameters.contact.local_response == LocalResponse::layer)
        warn_of_layer_patch(parameters, warnings);
      else if (parameters.impactor.is_cylinder())
        warn_of_strip(parameters, radius, warnings);
      else if (parameters.contact.load_is_singular())
        warn_of_point_load(parameters, section, result, warnings);
      else
        warn_of_disc(parameters, section, peak, radius, warnings);
    }



    /// A laminate that is dented although the scene says that it is not.
    void
    warn_of_dent(const Parameters   &parameters,
                 const ContactState &peak,
                 Warnings           &warnings)
    {
      const ContactParameters &contact = parameters.contact;
      if (parameters.plate.is_laminate() &&
          contact.unloading == UnloadingLaw::elastic &&
          peak.indentation > contact.critical_indentation)
        leave_model(
          warnings,
          peak.indentation / contact.critical_indentation,
          fmt::format("the indentation reaches {}, beyond the critical one, "
                      "{}: the contact leaves a dent, which Contact/Unloading "
                      "= Yang-Sun has",
                      about(peak.indentation, "m"),
                      about(contact.critical_indentation, "m")));
    }



    /// A law of unloading does not help: the loading is Hertz's in any case.
    void
    warn_of_yield(const Parameters   &parameters,
                  const ContactState &peak,
                  Warnings           &warnings)
    {
      const PlateParameters    &plate    = parameters.plate;
      const ImpactorParameters &impactor = parameters.impactor;
      const double              of_plate = PlateSection(plate).contact_modulus;
      const bool plate_is_softer         = of_plate < impactor.youngs_modulus;
      // Full plasticity begins at three times the yield strength, which is at
      // most a hundredth of Young's modulus (Johnson, Contact Mechanics, sec.
      // 6.3). A nearly incompressible body is an elastomer, which does not
      // yield; a lay-up has its own limit.
      if (plate_is_softer ?
            plate.is_laminate() || plate.poissons_ratio >= 0.45 :
            impactor.poissons_ratio >= 0.45)
        return;
      const double softer = std::min(of_plate, impactor.youngs_modulus),
                   pressure =
                     contact_pressure(parameters, peak.force, peak.indentation);
      if (pressure > 0.03 * softer)
        leave_model(
          warnings,
          pressure / (0.03 * softer),
          fmt::format("the contact pressure reaches {}, {} of Young's modulus: "
                      "no metal stays elastic beyond 0.03; the force is an "
                      "upper bound",
                      about(pressure, "Pa"),
                      about(pressure / softer)));
    }



    void
    warn_of_plate(const Parameters  &parameters,
                  const CycleResult &result,
                  Warnings          &warnings)
    {
      const double thickness = parameters.plate.thickness,
                   deflection =
                     result.history->max_plate_displacement() / thickness;
      if (deflection > 0.2)
        leave_model(
          warnings,
          deflection / 0.2,
          fmt::format("the plate deflects by {}, {} of its thickness: "
                      "beyond 0.2 it stiffens by membrane forces, which a "
                      "linear plate does not have",
                      about(deflection * thickness, "m"),
                      about(deflection)));
      const double to_edge = geometry_of(parameters.plate)->distance_to_edge();
      if (parameters.contact.local_response == LocalResponse::layer &&
          to_edge < 2. * thickness)
        leave_model(
          warnings,
          2. * thickness / to_edge,
          fmt::format("the impact is {}, {} thicknesses, from an edge: nearer "
                      "than 2 the plate answers other than a layer that goes "
                      "on for ever",
                      about(to_edge, "m"),
                      about(to_edge / thickness)));
    }



    /// The local response is a static one: measured (tests/layer/layer.py,
    /// doc/theory.md), a force is 0.3 % too large where the contact lasts ten
    /// transits of a shear wave through the plate, 0.2 to 0.7 % at eight to
    /// three, 1.1 % at two.
    void
    warn_of_short_contact(const Parameters     &parameters,
                          const ContactHistory &history,
                          Warnings             &warnings)
    {
      const std::optional<double> end  = history.first_contact_end();
      const double                rise = history.peak().time;
      if (parameters.contact.local_response != LocalResponse::layer ||
          (!end && rise == history.states().back().time))
        return;
      const PlateSection section(parameters.plate);
      const double       transit =
        std::sqrt(parameters.plate.thickness * section.mass_per_area /
                  section.shear_modulus);
      const double n_transits = end.value_or(2. * rise) / transit;
      // however short, the force is never far off
      if (n_transits < 10.)
        leave_model(
          warnings,
          1.,
          fmt::format("the contact lasts {} transits of a shear wave through "
                      "the plate: below 10 the local response, a static one, "
                      "makes the force up to a per cent too large",
                      about(n_transits)));
    }



    void
    warn_of_contact(const Parameters   &parameters,
                    const ContactState &peak,
                    Warnings           &warnings)
    {
      const double depth = peak.indentation / parameters.impactor.radius;
      if (depth > 0.1)
        leave_model(
          warnings,
          depth / 0.1,
          fmt::format("the indentation reaches {} of the impactor's radius: "
                      "the laws of contact are for less than 0.1",
                      about(depth)));
      const double half_width   = radius_at(parameters, peak),
                   of_thickness = half_width / parameters.plate.thickness;
      if (parameters.contact.local_response == LocalResponse::layer &&
          of_thickness > 0.2)
        leave_model(warnings,
                    of_thickness / 0.2,
                    fmt::format("the contact radius is {} of the plate's "
                                "thickness: from 0.2 on the pressure is not "
                                "Hertz's, which the local response assumes",
                                about(of_thickness)));
      const double length = parameters.impactor.length;
      if (parameters.impactor.is_cylinder() && half_width > 0.25 * length)
        leave_model(
          warnings,
          half_width / (0.25 * length),
          fmt::format("the contact is {} wide and {} long: the law of a "
                      "line contact is for one much longer than wide",
                      about(2. * half_width, "m"),
                      about(length, "m")));
    }
  } // namespace



  std::vector<std::string>
  Warnings::all() const
  {
    std::vector<std::string> result = numerical;
    result.insert(result.end(), model.begin(), model.end());
    return result;
  }



  Warnings
  model_warnings(const Parameters &parameters, const CycleResult &result)
  {
    Warnings            warnings;
    const ContactState &peak = result.history->peak();
    warn_of_load(parameters, PlateSection(parameters.plate), result, warnings);
    warn_of_plate(parameters, result, warnings);
    if (peak.force <= 0.)
      return warnings;
    warn_of_dent(parameters, peak, warnings);
    warn_of_yield(parameters, peak, warnings);
    warn_of_contact(parameters, peak, warnings);
    warn_of_short_contact(parameters, *result.history, warnings);
    return warnings;
  }
} // namespace PlateImpact
