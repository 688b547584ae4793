#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/analysis/model_limits.h"
#include "plate_impact/base/text.h"


namespace PlateImpact
{
  void
  ModelLimits::check_strengths()
  {
    // a laminate that is dented although the scene says that it is not; the
    // critical indentations are those of hard balls
    if (plate.is_laminate() && plate_is_softer &&
        contact.unloading == UnloadingLaw::elastic)
      limit(peak.indentation,
            contact.critical_indentation,
            "the indentation reaches {}, beyond the critical one, {}: the "
            "contact leaves a dent, which Contact/Unloading = Yang-Sun has",
            about(peak.indentation, "m"),
            about(contact.critical_indentation, "m"));
    warnings.contact = "pressure " + about(pressure, "Pa");
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
    const double bending = result.error->max_stresses(0, 0);
    limit(
      bending,
      plate.yield_strength,
      "the bending stress of the plate reaches {}, its yield strength is "
      "{}: beyond it the plate itself yields, which the model does not have",
      about(bending, "Pa"),
      about(plate.yield_strength, "Pa"));
  }



  void
  ModelLimits::check_yielding()
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
    warnings.contact =
      fmt::format("yields: mean pressure {} times the yield strength, dent {}",
                  about(bodies.mean_pressure(peak.force, peak.indentation) /
                        weaker.yield_strength),
                  about(history.states().back().permanent_indentation, "m"));
    leaves("contact that yields", 0.04);
    const double w = peak.indentation / *bodies.yield_indentation;
    limit(w,
          100.,
          "the indentation is {} times that at first yield: the law of "
          "a contact that yields was compared up to 100",
          about(w));
  }



  void
  ModelLimits::check_unknown_strength()
  {
    // A nearly incompressible body is an elastomer, which does not yield.
    if ((plate_is_softer ? plate.poissons_ratio : impactor.poissons_ratio) >=
        0.45)
      {
        warnings.contact +=
          " on a body like rubber, which does not yield, but is stiffer the "
          "faster it is struck: the force is that of the given modulus";
        return;
      }
    warnings.assumes_elastic_contact = true;
    warnings.contact +=
      fmt::format("{} elastic as long as the yield strength{} is above {}",
                  bodies.weaker ? "; the plate stays" : ",",
                  bodies.weaker ? " of the plate" : "",
                  about(bodies.elastic_strength(pressure), "Pa"));
    // Full plasticity begins at three times the yield strength, which is at
    // most a hundredth of Young's modulus (Johnson, Contact Mechanics, sec.
    // 6.3). A law of unloading does not help: the loading is Hertz's in any
    // case.
    const double softer =
      std::min(section.contact_modulus, impactor.youngs_modulus);
    limit(pressure,
          0.03 * softer,
          "the contact pressure reaches {}, {} of Young's modulus: no metal "
          "stays elastic beyond 0.03; the force is an upper bound",
          about(pressure, "Pa"),
          about(pressure / softer));
  }



  void
  ModelLimits::check_delamination()
  {
    const auto crack = delamination(parameters, expected, peak);
    if (!crack)
      return;
    const double      ratio     = peak.force / crack->threshold;
    const auto        of_model  = warnings.model_error();
    const std::string threshold = " the threshold, " +
      number(crack->threshold, "N") +
      (crack->is_of_small_mass ?
         ", of an impact whose waves are not back at its peak" :
         ", of an impact as slow as the plate");
    if (!result.peak_force_bar || !of_model || is_beyond_limits ||
        peak.time == history.states().back().time)
      warnings.damage = fmt::format(
        "the peak force is {} of{}; its error is not known, nor whether the "
        "plate delaminates",
        about(ratio),
        threshold);
    else
      {
        const double error =
          ratio * (result.peak_force_bar->total() + *of_model);
        if (ratio + error < 1.)
          warnings.damage =
            "no delamination expected: the peak force, with its "
            "errors, stays " +
            percentage(1. - ratio - error) + " below" + threshold;
        else if (ratio - error > 1.)
          warnings.damage = "delamination expected: the peak force, less its "
                            "errors, is " +
            percentage(ratio - error - 1.) + " above" + threshold;
        else
          warnings.damage = "delamination cannot be told: the errors of the "
                            "peak force reach over" +
            threshold;
      }
    limit(
      ratio,
      1.,
      "the peak force is {} of that from which on the laminate delaminates, "
      "{}: it is that of a plate which stays whole",
      about(ratio),
      about(crack->threshold, "N"));
  }
} // namespace PlateImpact
