#include "plate_impact/analysis/warnings.h"
#include "plate_impact/base/text.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/plate_geometry.h"

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// The limits of the model, what an impact inside of them may leave of the
    /// peak force, and the sentences for those that it passes.
    class ModelLimits : ComputedImpact, public Warnings
    {
    public:
      ModelLimits(const ComputedImpact &impact, const Warnings &before)
        : ComputedImpact(impact)
        , Warnings(before)
      {
        if (peak.force > 0.)
          {
            check_local_response();
            check_load();
          }
        check_plate();
        if (peak.force > 0.)
          {
            check_strengths();
            check_contact();
            check_duration();
            check_damping();
            check_delamination();
          }
        if (is_beyond_limits)
          leaves("what is beyond a limit of the model", {});
      }

    private:
      using ComputedImpact::contact;

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
        if (is_layer)
          leaves("local response", is_laminate ? 0.005 : 0.003);
        else
          leaves("local response of a half-space", is_laminate ? 0.15 : 0.08);
        if (is_layer && contact.finite_ball)
          return;
        // the same impact of a finite ball, by Zener's equation
        Parameters changed          = parameters;
        changed.contact.finite_ball = true;
        const ZenerImpact of_ball(make_contact(changed, /*layer_constant=*/0.),
                                  expected.impactor,
                                  section);
        leaves("ball taken for a half-space",
               std::abs(of_ball.peak.force / expected.peak.force - 1.));
      }

      /// Relative drop of the peak force when the radius of the load on the
      /// plate is halved a number of times: each time the plate gives way by F
      /// ln 2 / (2 pi kappa G t) more under it.
      double
      drop_by(const double halvings) const
      {
        // under the force of this impact, in proportion
        const double give = halvings * std::log(2.) * peak.force /
          expected.peak.force /
          (2. * std::acos(-1.) * section.mean_shear_stiffness());
        const ZenerImpact softer(expected.contact.in_series(give),
                                 expected.impactor,
                                 section);
        return 1. - softer.peak.force / expected.peak.force;
      }

      void
      check_load()
      {
        if (is_layer)
          check_patch();
        else if (impactor.is_cylinder())
          limit(
            contact.has_patch() ? contact.patch_radius : 0.,
            std::max(2. * radius, 0.5 * plate.thickness),
            "the force is spread over a strip of half-width {}, but the "
            "half-width of the contact is {}; choose Contact/Patch radius = {}",
            about(contact.patch_radius, "m"),
            about(radius, "m"),
            about(radius));
        else if (!contact.load_is_singular())
          {
            const double halvings = std::log2(contact.patch_radius / radius);
            const double change   = drop_by(halvings);
            if (std::abs(change) > 0.005)
              {
                leaves("patch radius", std::abs(change));
                warn(std::abs(change) / 0.05,
                     "Contact/Patch radius = {} m differs from the radius of "
                     "the contact, {}: the peak force is {} {} too {}; choose "
                     "Contact/Patch radius = {}",
                     about(contact.patch_radius),
                     about(radius, "m"),
                     contact.patch_radius > plate.thickness ? "more than" :
                                                              "about",
                     about_percentage(std::abs(change)),
                     change > 0. ? "large" : "small",
                     about(radius));
              }
            check_patch();
          }
        else if (const double drop = drop_by(1.); drop >= 1e-4)
          numerical.push_back(fmt::format(
            "the peak force under a point load does not converge: it depends "
            "on the smallest cell, {}, and drops by about {} per halving; "
            "choose Contact/Load distribution = Hertz disc",
            about(result.min_cell_size, "m"),
            about_percentage(drop)));
      }

      void
      check_patch()
      {
        // Load and reading with the rotations make plate and layer alike to
        // waves long against the patch only: measured, the force of the main
        // scene is 0.3 % too large with 1.5 thicknesses, 1.3 % with 3. No disc
        // blurs what a contact as wide does not send out.
        const double widest =
          std::max(1.5 * plate.thickness, is_layer ? 0. : 2. * radius);
        limit(contact.patch_radius / widest,
              1.,
              "Contact/Patch radius = {} m is {} thicknesses of the plate: a "
              "patch of more than {} thicknesses smooths out the waves that "
              "the contact sends out; choose Contact/Patch radius = 0",
              about(contact.patch_radius),
              about(contact.patch_radius / plate.thickness),
              about(widest / plate.thickness));
      }

      void
      check_plate()
      {
        const double deflection = history.max_plate_displacement(),
                     to_edge    = geometry_of(plate).distance_to_edge,
                     thickness  = plate.thickness;
        if (plate.has_large_deflection)
          {
            // of a dent that grows straight to the load, and twice that in a
            // clamped plate; von Karman's rotations are moderate, 10 to 15
            // degrees, and leave out the square of the slope beside one
            const double slope = 2. * deflection / to_edge;
            leaves("slopes", slope * slope);
            limit(
              slope,
              0.3,
              "the plate deflects by {} of the distance to its edge, so its "
              "slopes are about {}: von Karman's theory assumes moderate "
              "rotations and is valid for slopes up to 0.3",
              about(deflection / to_edge),
              about(slope));
          }
        else
          {
            // the static stiffness of a clamped plate grows by about 0.5
            // (w/h)^2 (Timoshenko & Woinowsky-Krieger, Theory of Plates and
            // Shells, sec. 100)
            const double relative = deflection / thickness;
            const double until_peak =
              history.max_plate_displacement(peak.time) / thickness;
            leaves("deflection", 0.5 * until_peak * until_peak);
            if (relative > 0.2)
              warn(relative / 0.2,
                   "the plate deflects by {}, {} of its thickness{}: beyond "
                   "0.2 membrane forces stiffen it, but the linear theory "
                   "leaves them out; choose Plate/Deflection = large{}",
                   about(deflection, "m"),
                   about(relative),
                   until_peak > 0.2 ? "" : ", after the peak of the force",
                   // bars of the force are those of linear plates
                   adaptivity.is_for_peak_force() ?
                     " and Adaptivity/Goal = energy norm" :
                     "");
            // what comes later leaves the error of the peak known
            is_beyond_limits = is_beyond_limits || until_peak > 0.2;
          }
        if (is_layer)
          limit(
            2. * thickness / to_edge,
            1.,
            "the impact is {} ({} thicknesses) from an edge: within 2 "
            "thicknesses the local response of an infinite layer is not valid",
            about(to_edge, "m"),
            about(to_edge / thickness));
      }

      void
      check_contact()
      {
        limit(peak.indentation / impactor.radius,
              0.1,
              "the indentation reaches {} of the impactor's radius: the "
              "contact laws are valid only below 0.1",
              about(peak.indentation / impactor.radius));
        // laminates were compared up to a third (tests/layer/laminate.py)
        const double widest = plate.is_laminate() ? 1. / 3. : 0.2;
        if (is_layer)
          limit(radius / plate.thickness,
                widest,
                "the contact radius is {} of the plate's thickness: the local "
                "response assumes Hertz's pressure, which holds only below {}",
                about(radius / plate.thickness),
                about(widest));
        if (impactor.is_cylinder())
          limit(radius,
                0.25 * impactor.length,
                "the contact is {} wide and {} long: the law of line contact "
                "is valid only if the contact is much longer than wide",
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
        const auto end = history.end_of_impact();
        if (!is_layer || (!end && peak.time == last.time))
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
             "plate: the local response is static, and below 10 transits it "
             "makes the force up to one per cent too large",
             about(n_transits));
      }

      /// A loss factor that grows in proportion to the frequency is that of a
      /// material near the first natural frequency only.
      void
      check_damping()
      {
        if (plate.loss_factor == 0.)
          return;
        const double of_contact = result.loss_factor_of_contact();
        limit(of_contact,
              0.3,
              "Plate/Loss factor = {} holds at the first natural frequency and "
              "grows to {} at the frequency of the contact: beyond 0.3 the "
              "damping stiffens the plate; choose at most {}",
              about(plate.loss_factor),
              about(of_contact),
              about(0.3 * plate.loss_factor / of_contact));
      }

      /// Whether the bodies yield or the plate's faces do, by their strengths.
      void
      check_strengths()
      {
        // a laminate that is dented although the scene says that it is not; the
        // critical indentations are those of hard balls
        if (plate.is_laminate() && plate_is_softer &&
            contact.unloading == UnloadingLaw::elastic)
          limit(
            peak.indentation,
            contact.critical_indentation,
            "the indentation reaches {}, beyond Contact/Critical indentation, "
            "{}: the contact leaves a dent; choose Contact/Unloading = "
            "Yang-Sun",
            about(peak.indentation, "m"),
            about(contact.critical_indentation, "m"));
        Warnings::contact = "pressure " + about(pressure, "Pa");
        if (bodies.weaker)
          check_yielding();
        // a ball without a strength is taken for one that does not yield, but
        // beside a laminate, which has none
        if (plate.is_laminate() ? !plate_is_softer && !bodies.weaker :
                                  plate.yield_strength == 0.)
          check_unknown_strength();
        if (plate.yield_strength == 0. || !result.error ||
            result.error->max_stresses.size() != 1)
          return;
        const double largest = result.error->max_stresses(0, 0);
        limit(
          largest,
          plate.yield_strength,
          "the stress at the faces of the plate reaches {}, beyond its yield "
          "strength, {}: the plate itself yields, which the model leaves out",
          about(largest, "Pa"),
          about(plate.yield_strength, "Pa"));
      }

      /// The law of a contact that yields was compared up to w = 100
      /// (doc/validation.md).
      void
      check_yielding()
      {
        const double first = bodies.weaker->first_yield_pressure;
        if (pressure <= first)
          {
            Warnings::contact =
              fmt::format("elastic: pressure {}, first yield at {}",
                          about(pressure, "Pa"),
                          about(first, "Pa"));
            return;
          }
        if (impactor.is_cylinder())
          {
            Warnings::contact +=
              "; it yields, but there is no yielding law for line contact";
            return limit(
              pressure,
              first,
              "the contact pressure reaches {}, and the contact yields "
              "from {} on, but there is no yielding law for line "
              "contact; the force is an upper bound",
              about(pressure, "Pa"),
              about(first, "Pa"));
          }
        Warnings::contact = fmt::format(
          "yields: mean pressure {} times the yield strength, dent {}",
          about(bodies.mean_pressure(peak.force, peak.indentation) /
                bodies.weaker->yield_strength),
          about(last.permanent_indentation, "m"));
        leaves("contact that yields", 0.04);
        const double w = peak.indentation / *bodies.yield_indentation;
        limit(w,
              100.,
              "the indentation is {} times that at first yield: the law of "
              "yielding contacts was tested only up to 100",
              about(w));
      }

      /// Of a body that may yield, but whose strength is not given.
      void
      check_unknown_strength()
      {
        // A nearly incompressible body is an elastomer, which does not yield.
        if ((plate_is_softer ? plate.poissons_ratio :
                               impactor.poissons_ratio) >= 0.45)
          {
            Warnings::contact +=
              " on a rubber-like body, which does not yield but is stiffer in "
              "faster impacts: the force is that for the given modulus";
            return;
          }
        assumes_elastic_contact = true;
        Warnings::contact +=
          fmt::format("{} elastic as long as the yield strength{} is above {}",
                      bodies.weaker ? "; the plate stays" : ",",
                      bodies.weaker ? " of the plate" : "",
                      about(pressure / bodies.pressure_over_strength, "Pa"));
        // Full plasticity begins at three times the yield strength, which is at
        // most a hundredth of Young's modulus (Johnson, Contact Mechanics, sec.
        // 6.3). A law of unloading does not help: the loading is Hertz's in any
        // case.
        const double softer =
          std::min(section.contact_modulus, impactor.youngs_modulus);
        limit(
          pressure,
          0.03 * softer,
          "the contact pressure reaches {}, {} of Young's modulus: no metal "
          "stays elastic beyond 0.03, hardly a polymer beyond 0.05; the force "
          "is an upper bound",
          about(pressure, "Pa"),
          about(pressure / softer));
      }

      /// Whether a laminate delaminates; after all other limits.
      void
      check_delamination()
      {
        const auto crack = delamination(*this);
        if (!crack)
          return;
        const double      ratio     = peak.force / crack->threshold;
        const auto        of_model  = model_error();
        const std::string threshold = " the threshold, " +
          number(crack->threshold, "N") +
          (crack->is_of_small_mass ?
             ", for a small-mass impact (no wave returns before the peak)" :
             ", for a quasi-static impact");
        if (!result.peak_force_bar || !of_model || is_beyond_limits ||
            peak.time == last.time)
          damage = fmt::format(
            "the peak force is {} of{}; the error of the force is not known, "
            "so delamination cannot be judged",
            about(ratio),
            threshold);
        else
          {
            const double error =
              ratio * (result.peak_force_bar->total() + *of_model);
            if (ratio + error < 1.)
              damage =
                "no delamination expected: the peak force, with its errors, "
                "stays " +
                percentage(1. - ratio - error) + " below" + threshold;
            else if (ratio - error > 1.)
              damage = "delamination expected: the peak force, less its "
                       "errors, is " +
                percentage(ratio - error - 1.) + " above" + threshold;
            else
              damage = "delamination is possible: the peak force, within "
                       "its errors, may be below or above" +
                threshold;
          }
        limit(ratio,
              1.,
              "the peak force is {} times the delamination threshold, {}: the "
              "force is that of a plate without delamination",
              about(ratio),
              about(crack->threshold, "N"));
      }

      const bool is_layer = contact.local_response == LocalResponse::layer;
      /// Or half-width of the contact.
      const double radius = bodies.radius(peak.force, peak.indentation);
      const bool   plate_is_softer =
        section.contact_modulus < impactor.youngs_modulus;
      /// Largest of an elastic contact.
      const double pressure =
        bodies.elastic_pressure(peak.force, peak.indentation);
    };
  } // namespace



  Warnings
  model_warnings(const ComputedImpact &impact, const Warnings &before)
  {
    return ModelLimits(impact, before);
  }
} // namespace PlateImpact
