#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/contact_bodies.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/contact/yielding_law.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  namespace
  {
    /// The limits of the model, and the sentences for those that an impact
    /// passes.
    class ModelLimits
    {
    public:
      ModelLimits(const Parameters &parameters, const CycleResult &result)
        : parameters(parameters)
        , plate(parameters.plate)
        , impactor(parameters.impactor)
        , contact(parameters.contact)
        , section(plate)
        , is_layer(contact.local_response == LocalResponse::layer)
        , smallest_cell(result.min_cell_size)
        , history(*result.history)
        , peak(history.peak())
        , bodies(parameters)
        , radius(bodies.radius(peak.force, peak.indentation))
        , pressure(peak.force > 0. ?
                     bodies.pressure(peak.force, peak.indentation) :
                     0.)
      {
        if (result.error && result.error->max_stresses.size() == 1)
          bending_stress = result.error->max_stresses(0, 0);
      }

      Warnings
      warnings_of_all()
      {
        if (peak.force > 0.)
          {
            check_local_response();
            check_load();
          }
        check_plate();
        if (peak.force > 0.)
          {
            check_bodies();
            check_contact();
            check_duration();
          }
        if (is_beyond_limits)
          leaves("what is beyond a limit of the model", {});
        return warnings;
      }

    private:
      /// Notes what a part of the model leaves of the peak force.
      void
      leaves(const std::string &part, const std::optional<double> &relative)
      {
        warnings.model_errors.push_back({part, relative});
      }

      /// Notes a sentence, with {} for each number.
      template <typename... Numbers>
      void
      warn(const double over_limit,
           const char  *sentence,
           const Numbers &...numbers)
      {
        warnings.model.push_back(fmt::format(sentence, numbers...));
        warnings.farthest_from_model =
          std::max(warnings.farthest_from_model, over_limit);
      }

      /// The same where a quantity passes its limit, beyond which the error is
      /// not known.
      template <typename... Numbers>
      void
      limit(const double quantity,
            const double limit,
            const char  *sentence,
            const Numbers &...numbers)
      {
        if (quantity <= limit)
          return;
        warn(quantity / limit, sentence, numbers...);
        is_beyond_limits = true;
      }

      /// What the contact takes for the answer of plate and ball to short
      /// waves, as far as doc/validation.md has compared it.
      void
      check_local_response()
      {
        const bool is_laminate  = plate.is_laminate(),
                   was_compared = !impactor.is_cylinder() &&
          (is_laminate || contact.law == ForceLaw::Hertz) &&
          contact.has_patch() && plate.shear_correction_factor < 10.;
        if (!was_compared)
          return leaves("local response", {});
        if (!is_layer)
          return leaves("local response of a half-space",
                        is_laminate ? 0.15 : 0.08);
        leaves("local response", is_laminate ? 0.005 : 0.003);
        if (contact.finite_ball)
          return;
        // the same impact of a finite ball, by Zener's equation
        Parameters changed          = parameters;
        changed.contact.finite_ball = true;
        const auto force            = [&](const Parameters &scene) {
          return ZenerImpact(make_contact(scene, /*layer_constant=*/0.),
                             make_impactor(impactor),
                             section)
            .peak.force;
        };
        leaves("ball taken for a half-space",
               std::abs(force(changed) / force(parameters) - 1.));
      }

      /// When the radius of the load on the plate is halved, the plate gives
      /// way by F ln 2 / (2 pi kappa G t) more under it; relative to the
      /// indentation.
      double
      give_per_halving() const
      {
        return peak.force * std::log(2.) /
          (2. * std::acos(-1.) * section.mean_shear_stiffness() *
           peak.indentation);
      }

      /// Relative drop of the peak force then, as if the contact were softer by
      /// as much.
      double
      drop_per_halving() const
      {
        // F = k alpha^{3/2}, k grows with the root of the radius
        const auto force = [&](const double factor_of_k) {
          Parameters changed = parameters;
          changed.impactor.radius *= factor_of_k * factor_of_k;
          return make_zener_impact(changed).peak.force;
        };
        const double step     = 0.05;
        const double exponent = std::log(force(1. + step) / force(1. - step)) /
          std::log((1. + step) / (1. - step));
        return 1.5 * give_per_halving() * exponent;
      }

      void
      check_load()
      {
        // Load and reading with the rotations make plate and layer alike to
        // waves long against the patch only: measured, the force of the main
        // scene is 0.3 % too large with 1.5 thicknesses, 1.3 % with 3.
        if (is_layer)
          limit(contact.patch_radius / plate.thickness,
                1.5,
                "Contact/Patch radius = {} m is {} thicknesses of the plate: "
                "beyond 1.5 it blurs the waves that the contact sends out; "
                "choose Contact/Patch radius = 0",
                about(contact.patch_radius),
                about(contact.patch_radius / plate.thickness));
        else if (impactor.is_cylinder())
          limit(contact.has_patch() ? contact.patch_radius : 0.,
                std::max(2. * radius, 0.5 * plate.thickness),
                "the force is spread over a strip of half-width {}, but the "
                "contact is {} wide; choose Contact/Patch radius = {}",
                about(contact.patch_radius, "m"),
                about(radius, "m"),
                about(radius));
        else if (contact.load_is_singular())
          check_point_load();
        else
          check_disc();
      }

      void
      check_point_load()
      {
        if (const double drop = drop_per_halving(); drop >= 1e-4)
          warnings.numerical.push_back(fmt::format(
            "the peak force under a point load has no limit: it depends on the "
            "smallest cell, {}, and drops by about {} per halving; for a limit "
            "choose Contact/Load distribution = Hertz disc",
            about(smallest_cell, "m"),
            about_percentage(drop)));
      }

      void
      check_disc()
      {
        const double halvings = std::log2(contact.patch_radius / radius);
        // a force grows at most like k^{2/5}
        if (0.6 * give_per_halving() * std::abs(halvings) < 0.005)
          return;
        const double change = drop_per_halving() * halvings;
        if (std::abs(change) <= 0.005)
          return;
        leaves("patch radius", std::abs(change));
        warn(std::abs(change) / 0.05,
             "Contact/Patch radius = {} m spreads the force over another "
             "area than the contact, whose radius is {}: the peak force is "
             "{} {} too {}; choose Contact/Patch radius = {}",
             about(contact.patch_radius),
             about(radius, "m"),
             contact.patch_radius > plate.thickness ? "more than" : "about",
             about_percentage(std::abs(change)),
             change > 0. ? "large" : "small",
             about(radius));
      }

      void
      check_plate()
      {
        const double deflection = history.max_plate_displacement(),
                     to_edge    = geometry_of(plate)->distance_to_edge(),
                     thickness  = plate.thickness;
        // the static stiffness of a clamped plate grows by about 0.5 (w/h)^2
        // (Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells, sec.
        // 100)
        leaves("deflection",
               0.5 * std::pow(peak.plate_displacement / thickness, 2));
        limit(deflection / thickness,
              0.2,
              "the plate deflects by {}, {} of its thickness: beyond 0.2 it "
              "stiffens by membrane forces, which a linear plate does not have",
              about(deflection, "m"),
              about(deflection / thickness));
        if (is_layer)
          limit(2. * thickness / to_edge,
                1.,
                "the impact is {}, {} thicknesses, from an edge: nearer than 2 "
                "the plate answers other than a layer that goes on for ever",
                about(to_edge, "m"),
                about(to_edge / thickness));
      }

      void
      check_bodies()
      {
        // a laminate that is dented although the scene says that it is not
        if (plate.is_laminate() && contact.unloading == UnloadingLaw::elastic)
          limit(peak.indentation,
                contact.critical_indentation,
                "the indentation reaches {}, beyond the critical one, {}: the "
                "contact leaves a dent, which Contact/Unloading = Yang-Sun has",
                about(peak.indentation, "m"),
                about(contact.critical_indentation, "m"));
        if (bodies.weaker)
          check_yielding();
        else
          check_elastic();
        if (plate.yield_strength > 0. && bending_stress)
          limit(
            *bending_stress,
            plate.yield_strength,
            "the bending stress of the plate reaches {}, its yield strength "
            "is {}: beyond it the plate itself yields, which the model does "
            "not have",
            about(*bending_stress, "Pa"),
            about(plate.yield_strength, "Pa"));
      }

      /// The law of a contact that yields was compared up to w = 100
      /// (doc/validation.md).
      void
      check_yielding()
      {
        const YieldingBody &weaker = *bodies.weaker;
        const double        first  = bodies.first_yield_pressure();
        if (pressure <= first)
          {
            warnings.contact =
              fmt::format("elastic: pressure {}, first yield at {}",
                          about(pressure, "Pa"),
                          about(first, "Pa"));
            return;
          }
        if (impactor.is_cylinder())
          {
            warnings.contact = "pressure " + about(pressure, "Pa") +
              "; it yields, for which a line contact has no law";
            return limit(pressure,
                         first,
                         "the contact pressure reaches {}, and the contact "
                         "yields from {} on, for which a line contact has no "
                         "law; the force is an upper bound",
                         about(pressure, "Pa"),
                         about(first, "Pa"));
          }
        warnings.contact = fmt::format(
          "yields: mean pressure {} times the yield strength, dent {}",
          about(2. / 3. * pressure / weaker.yield_strength),
          about(history.states().back().permanent_indentation, "m"));
        leaves("contact that yields", 0.04);
        const double w = peak.indentation / *bodies.yield_indentation;
        limit(w,
              100.,
              "the indentation is {} times that at first yield: the law of "
              "a contact that yields was compared up to 100",
              about(w));
      }

      /// Nothing is said of a strength.
      void
      check_elastic()
      {
        const bool plate_is_softer =
          section.contact_modulus < impactor.youngs_modulus;
        const double softer =
          std::min(section.contact_modulus, impactor.youngs_modulus);
        warnings.contact = "pressure " + about(pressure, "Pa");
        if (plate_is_softer && plate.is_laminate())
          return; // which has its own limit
        warnings.assumes_elastic_contact = true;
        // A nearly incompressible body is an elastomer, which does not yield.
        if ((plate_is_softer ? plate.poissons_ratio :
                               impactor.poissons_ratio) >= 0.45)
          {
            warnings.contact +=
              " on a body like rubber, which does not yield, but is stiffer the "
              "faster it is struck: the force is that of the given modulus";
            return;
          }
        warnings.contact +=
          fmt::format(", elastic as long as the yield strength is above {}",
                      about(bodies.elastic_strength(pressure), "Pa"));
        // Full plasticity begins at three times the yield strength, which is at
        // most a hundredth of Young's modulus (Johnson, Contact Mechanics, sec.
        // 6.3). A law of unloading does not help: the loading is Hertz's in any
        // case.
        limit(pressure,
              0.03 * softer,
              "the contact pressure reaches {}, {} of Young's modulus: no "
              "metal stays elastic beyond 0.03; the force is an upper bound",
              about(pressure, "Pa"),
              about(pressure / softer));
      }

      void
      check_contact()
      {
        limit(peak.indentation / impactor.radius,
              0.1,
              "the indentation reaches {} of the impactor's radius: the laws "
              "of contact are for less than 0.1",
              about(peak.indentation / impactor.radius));
        // laminates were compared up to a third (tests/layer/laminate.py)
        const double widest = plate.is_laminate() ? 1. / 3. : 0.2;
        if (is_layer)
          limit(radius / plate.thickness,
                widest,
                "the contact radius is {} of the plate's thickness: from {} "
                "on the pressure is not Hertz's, which the local response "
                "assumes",
                about(radius / plate.thickness),
                about(widest));
        if (impactor.is_cylinder())
          limit(radius,
                0.25 * impactor.length,
                "the contact is {} wide and {} long: the law of a line contact "
                "is for one much longer than wide",
                about(2. * radius, "m"),
                about(impactor.length, "m"));
      }

      /// The local response is a static one: measured (tests/layer/layer.py,
      /// doc/theory.md), a force is 0.3 % too large where the contact lasts ten
      /// transits of a shear wave through the plate, 0.2 to 0.7 % at eight to
      /// three, 1.1 % at two: however short, the force is never far off.
      void
      check_duration()
      {
        const auto end = history.first_contact_end();
        if (!is_layer || (!end && peak.time == history.states().back().time))
          return;
        const double transit = std::sqrt(
          plate.thickness * section.mass_per_area / section.shear_modulus);
        const double n_transits = end.value_or(2. * peak.time) / transit;
        if (n_transits >= 10.)
          return;
        leaves("short contact",
               n_transits > 1.8 ? std::optional(0.012) : std::nullopt);
        warn(1.,
             "the contact lasts {} transits of a shear wave through the "
             "plate: below 10 the local response, a static one, makes the "
             "force up to a per cent too large",
             about(n_transits));
      }

      const Parameters         &parameters;
      const PlateParameters    &plate;
      const ImpactorParameters &impactor;
      const ContactParameters  &contact;
      const PlateSection        section;
      const bool                is_layer;
      const double              smallest_cell;
      const ContactHistory     &history;
      const ContactState       &peak;
      const ContactBodies       bodies;
      const double              radius;   ///< or half-width of the contact
      const double              pressure; ///< largest of the contact
      std::optional<double>     bending_stress; ///< of an isotropic plate [Pa]
      bool                      is_beyond_limits = false;
      Warnings                  warnings;
    };
  } // namespace



  std::vector<std::string>
  Warnings::all() const
  {
    std::vector<std::string> result = numerical;
    result.insert(result.end(), model.begin(), model.end());
    return result;
  }



  std::optional<double>
  Warnings::model_error() const
  {
    double sum = 0.;
    for (const ModelError &error : model_errors)
      {
        if (!error.relative)
          return {};
        sum += *error.relative;
      }
    return sum;
  }



  Warnings
  model_warnings(const Parameters &parameters, const CycleResult &result)
  {
    return ModelLimits(parameters, result).warnings_of_all();
  }
} // namespace PlateImpact
