#include "plate_impact/base/text.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/output/report.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"

#include <cmath>
#include <filesystem>

namespace PlateImpact
{
  namespace
  {
    std::string
    place_in_words(const PlateParameters &plate)
    {
      const auto &point = plate.impact_point;
      if (point[0] == 0. && point[1] == 0.)
        return "the middle of";
      if (plate.is_circle())
        return about(std::hypot(point[0], point[1]), "m") +
          " from the middle of";
      const PrefixedUnit unit("m",
                              std::max(std::abs(point[0]), std::abs(point[1])));
      return number(unit(point[0])) + " and " + unit.text(point[1]) +
        ", along x and y, from the middle of";
    }



    template <typename Support>
    std::string
    supports_in_words(const std::vector<OnEdge<Support>> &supports)
    {
      if (supports.front().edge.empty())
        return word_for(supports.front().support) +
          (supports.back().support == supports.front().support ?
             "" :
             " (x edges) and " + word_for(supports.back().support) +
               " (y edges)");
      std::string text;
      for (const auto &[edge, support] : supports)
        text +=
          (text.empty() ? "" : ", ") + word_for(support) + " (" + edge + ")";
      return text;
    }



    /// Larger bars are told as a doubt, unless the scene asks for no better.
    /// Relative to the force.
    constexpr double small_bar = 0.01;

    /// Times a limit of the model beyond which its numbers say nothing: a
    /// clamped plate that deflects by 0.6 of its thickness is stiffer by a
    /// sixth.
    constexpr double far_from_model = 3.;



    void
    lower(Verdict::Part &part, const Trust trust, const std::string &why)
    {
      part.trust = std::max(part.trust, trust);
      part.reasons.push_back(why);
    }



    Verdict::Part
    convergence_of(const Parameters               &parameters,
                   const Outcome                   outcome,
                   const CycleResult              &last,
                   const std::vector<std::string> &warnings)
    {
      const AdaptivityParameters &adaptivity = parameters.adaptivity;
      Verdict::Part               part;
      if (outcome != Outcome::single_mesh && outcome != Outcome::target_reached)
        part.trust = Trust::doubtful; // a warning says why
      if (outcome == Outcome::single_mesh && !adaptivity.is_adaptive())
        lower(part, Trust::doubtful, "the mesh was not made for a target");
      if (!last.peak_force_error)
        lower(part, Trust::doubtful, "no error was estimated");
      else if (!last.peak_force_bar)
        lower(part,
              Trust::none,
              "there is no bar: the mesh does not resolve the load or the "
              "waves that the contact sends out, or the time step is too "
              "coarse to estimate its error");
      else if (last.peak_force_bar->total() >
               (adaptivity.goal == AdaptationGoal::peak_force ?
                  adaptivity.target_peak_force_error :
                  small_bar))
        lower(part,
              Trust::doubtful,
              "the error bar of the force is " +
                about_percentage(last.peak_force_bar->total()));
      const double drift = last.history->relative_energy_drift();
      if (drift > 0.1)
        lower(part,
              Trust::none,
              "the total energy changes by " + about_percentage(drift));
      for (const std::string &warning : warnings)
        lower(part, Trust::doubtful, warning);
      return part;
    }



    std::string
    force_in_words(const CycleResult           &last,
                   const std::optional<double> &model_error)
    {
      const double force = last.history->peak().force;
      const auto  &bar   = last.peak_force_bar;
      std::string  text =
        with_error(force, bar ? bar->total() * force : 0., "N");
      if (force == 0.)
        return text;
      if (!bar)
        return text + ", error not known";
      return text + " (mesh, step)" +
        (model_error ?
           " ± " + error_in_words(*model_error * force, force, "N") +
             " (model, from comparisons)" :
           ", error of the model not known");
    }
  } // namespace



  std::string
  scene_in_words(const Parameters &parameters)
  {
    const PlateParameters &plate = parameters.plate;
    const PrefixedUnit     side("m",
                            std::max(geometry_of(plate).side_lengths[0],
                                     geometry_of(plate).side_lengths[1])),
      thickness("m", plate.thickness);
    const std::string extent = plate.is_circle() ?
      "round plate of " + side.text(plate.side_lengths[0]) + " diameter, " :
      (plate.is_from_file() ? "plate (" +
           std::filesystem::path(plate.outline.file).filename().string() +
           ") of " :
                              "plate of ") +
        number(side(geometry_of(plate).side_lengths[0])) + " × " +
        side.text(geometry_of(plate).side_lengths[1]) + ", ";
    const std::string target = extent + thickness.text(plate.thickness) +
      " thick, " +
      (plate.is_laminate() ? "plies " + plate.layup.text + ", " : "") +
      supports_in_words(plate.supports) +
      (PlateSection(plate).stretching == Stretching::none ?
         "" :
         ", " + supports_in_words(plate.in_plane_supports) + " in its plane") +
      (plate.has_large_deflection ? ", with large deflections" : "");
    if (!parameters.has_impactor())
      return "A " + target + ". Nothing strikes it.";

    const ImpactorParameters &impactor = parameters.impactor;
    const double              mass     = make_impactor(impactor).mass;
    return "A " + word_for(impactor.shape) + " of radius " +
      number(impactor.radius, "m") + " and mass " +
      (mass < 1. ? number(1e3 * mass, "g") : rounded(mass) + " kg") +
      " strikes " + place_in_words(plate) + " a " + target + ", at " +
      number(impactor.velocity, "m/s") + ".";
  }



  std::string
  local_response_in_words(const Parameters &parameters)
  {
    const ContactParameters &contact = parameters.contact;
    if (contact.local_response == LocalResponse::layer)
      return "layer, as in three-dimensional elasticity";
    // the shear of a homogeneous plate has a factor of 5/6
    if (parameters.plate.shear_correction_factor > 10.)
      return "half-space, for a plate without shear deformation";
    std::string text = "half-space, in addition to the plate's shear: the "
                       "shortest waves count twice, so the force is too small";
    if (contact.law == ForceLaw::Sun)
      text += "; the law Sun allows no other";
    else if (!contact.has_patch())
      text +=
        "; a " + word_for(contact.load_distribution) + " load allows no other";
    return text;
  }



  Verdict
  verdict_of(const Parameters  &parameters,
             const Outcome      outcome,
             const CycleResult &last,
             const Warnings    &warnings)
  {
    Verdict verdict;
    verdict.warnings = warnings;
    if (!last.history)
      {
        verdict.text = "nothing strikes the plate";
        return verdict;
      }
    verdict.force = force_in_words(last, warnings.model_error());
    verdict.text  = verdict.force + ": " +
      (outcome == Outcome::target_reached ? "target met" :
         outcome != Outcome::single_mesh  ? "target missed (" +
           word_for(outcome) + ")" :
         parameters.adaptivity.is_adaptive() ? "one mesh" :
                                               "one mesh, no target");
    verdict.convergence =
      convergence_of(parameters, outcome, last, warnings.numerical);
    if (warnings.assumes_elastic_contact)
      lower(verdict.model,
            Trust::doubtful,
            "an elastic contact is assumed: " + warnings.contact);
    for (const std::string &warning : warnings.model)
      lower(verdict.model,
            warnings.farthest_from_model > far_from_model ? Trust::none :
                                                            Trust::doubtful,
            warning);
    return verdict;
  }
} // namespace PlateImpact
