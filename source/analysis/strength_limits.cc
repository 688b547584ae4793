#include "plate_impact/analysis/model_notes.h"
#include "plate_impact/base/text.h"

namespace PlateImpact
{
  namespace
  {
    /// The strengths of bodies and plate that an impact asks for.
    class StrengthLimits : ComputedImpact
    {
    public:
      StrengthLimits(const ComputedImpact &impact, ModelNotes &notes)
        : ComputedImpact(impact)
        , notes(notes)
      {
        // a laminate that is dented although the scene says that it is not; the
        // critical indentations are those of hard balls
        if (plate.is_laminate() && plate_is_softer &&
            contact.unloading == UnloadingLaw::elastic)
          notes.limit(
            peak.indentation,
            contact.critical_indentation,
            "the indentation reaches {}, beyond Contact/Critical indentation, "
            "{}: the contact leaves a dent; choose Contact/Unloading = "
            "Yang-Sun",
            about(peak.indentation, "m"),
            about(contact.critical_indentation, "m"));
        notes.warnings.contact = "pressure " + about(pressure, "Pa");
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
        notes.limit(
          largest,
          plate.yield_strength,
          "the stress at the faces of the plate reaches {}, beyond its yield "
          "strength, {}: the plate itself yields, which the model leaves out",
          about(largest, "Pa"),
          about(plate.yield_strength, "Pa"));
      }

    private:
      /// The law of a contact that yields was compared up to w = 100
      /// (doc/validation.md).
      void
      check_yielding()
      {
        const YieldingBody &weaker = *bodies.weaker;
        const double        first  = bodies.first_yield_pressure;
        if (pressure <= first)
          {
            notes.warnings.contact =
              fmt::format("elastic: pressure {}, first yield at {}",
                          about(pressure, "Pa"),
                          about(first, "Pa"));
            return;
          }
        if (impactor.is_cylinder())
          {
            notes.warnings.contact = "pressure " + about(pressure, "Pa") +
              "; it yields, but there is no yielding law for line contact";
            return notes.limit(
              pressure,
              first,
              "the contact pressure reaches {}, and the contact yields "
              "from {} on, but there is no yielding law for line "
              "contact; the force is an upper bound",
              about(pressure, "Pa"),
              about(first, "Pa"));
          }
        notes.warnings.contact = fmt::format(
          "yields: mean pressure {} times the yield strength, dent {}",
          about(bodies.mean_pressure(peak.force, peak.indentation) /
                weaker.yield_strength),
          about(last.permanent_indentation, "m"));
        notes.leaves("contact that yields", 0.04);
        const double w = peak.indentation / *bodies.yield_indentation;
        notes.limit(
          w,
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
            notes.warnings.contact +=
              " on a rubber-like body, which does not yield but is stiffer in "
              "faster impacts: the force is that for the given modulus";
            return;
          }
        notes.warnings.assumes_elastic_contact = true;
        notes.warnings.contact +=
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
        notes.limit(
          pressure,
          0.03 * softer,
          "the contact pressure reaches {}, {} of Young's modulus: no metal "
          "stays elastic beyond 0.03, hardly a polymer beyond 0.05; the force "
          "is an upper bound",
          about(pressure, "Pa"),
          about(pressure / softer));
      }

      ModelNotes &notes;
      const bool  plate_is_softer =
        section.contact_modulus < impactor.youngs_modulus;
      /// Largest of an elastic contact.
      const double pressure =
        bodies.elastic_pressure(peak.force, peak.indentation);
    };
  } // namespace



  void
  check_strengths(const ComputedImpact &impact, ModelNotes &notes)
  {
    StrengthLimits(impact, notes);
  }



  void
  check_delamination(const ComputedImpact &impact, ModelNotes &notes)
  {
    const auto crack = delamination(impact);
    if (!crack)
      return;
    const double      ratio     = impact.peak.force / crack->threshold;
    const auto        of_model  = notes.warnings.model_error();
    const std::string threshold = " the threshold, " +
      number(crack->threshold, "N") +
      (crack->is_of_small_mass ?
         ", for a small-mass impact (no wave returns before the peak)" :
         ", for a quasi-static impact");
    if (!impact.result.peak_force_bar || !of_model || notes.is_beyond_limits ||
        impact.peak.time == impact.last.time)
      notes.warnings.damage = fmt::format(
        "the peak force is {} of{}; the error of the force is not known, "
        "so delamination cannot be judged",
        about(ratio),
        threshold);
    else
      {
        const double error =
          ratio * (impact.result.peak_force_bar->total() + *of_model);
        if (ratio + error < 1.)
          notes.warnings.damage =
            "no delamination expected: the peak force, with its errors, "
            "stays " +
            percentage(1. - ratio - error) + " below" + threshold;
        else if (ratio - error > 1.)
          notes.warnings.damage =
            "delamination expected: the peak force, less its "
            "errors, is " +
            percentage(ratio - error - 1.) + " above" + threshold;
        else
          notes.warnings.damage =
            "delamination is possible: the peak force, within "
            "its errors, may be below or above" +
            threshold;
      }
    notes.limit(
      ratio,
      1.,
      "the peak force is {} times the delamination threshold, {}: the "
      "force is that of a plate without delamination",
      about(ratio),
      about(crack->threshold, "N"));
  }
} // namespace PlateImpact
