#include "plate_impact/output/verdict.h"

#include "plate_impact/base/text.h"

#include <algorithm>

namespace PlateImpact
{
  template <>
  const std::vector<Word<Trust>> Choices<Trust>::words = {
    {Trust::good, "good"},
    {Trust::doubtful, "doubtful"},
    {Trust::none, "none"}};



  namespace
  {
    /// Whether the run has met what the scene asks for, in words.
    std::string
    result_in_words(const Parameters &parameters, const Outcome outcome)
    {
      if (outcome == Outcome::target_reached)
        return "target met";
      if (outcome == Outcome::single_mesh)
        return parameters.adaptivity.is_adaptive() ? "one mesh" :
                                                     "one mesh, no target";
      return "target missed (" + word_for(outcome) + ")";
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



    /// What there is in place of an error bar, or with one that is large.
    void
    judge_bar(Verdict::Part              &part,
              const AdaptivityParameters &adaptivity,
              const CycleResult          &last)
    {
      const double largest = adaptivity.goal == AdaptationGoal::peak_force ?
        adaptivity.target_peak_force_error :
        small_bar;
      if (!last.peak_force_bar)
        lower(part,
              last.peak_force_error ? Trust::none : Trust::doubtful,
              last.peak_force_error ?
                "there is no bar: the mesh does not resolve the load or the "
                "waves that the contact sends out, or the time step is too "
                "coarse to estimate its error" :
                "no error was estimated");
      else if (last.peak_force_bar->total() > largest)
        lower(part,
              Trust::doubtful,
              "the error bar of the force is " +
                about_percentage(last.peak_force_bar->total()));
    }



    Verdict::Part
    convergence_of(const Parameters               &parameters,
                   const Outcome                   outcome,
                   const CycleResult              &last,
                   const std::vector<std::string> &warnings)
    {
      Verdict::Part part;
      if (outcome != Outcome::single_mesh && outcome != Outcome::target_reached)
        part.trust = Trust::doubtful; // a warning says why
      if (outcome == Outcome::single_mesh &&
          !parameters.adaptivity.is_adaptive())
        lower(part, Trust::doubtful, "the mesh was not made for a target");
      judge_bar(part, parameters.adaptivity, last);
      const double drift = last.history->relative_energy_drift();
      if (drift > 0.1)
        lower(part,
              Trust::none,
              "the total energy changes by " + about_percentage(drift));
      for (const std::string &warning : warnings)
        lower(part, Trust::doubtful, warning);
      return part;
    }
  } // namespace



  std::string
  force_in_words(const CycleResult           &last,
                 const std::optional<double> &model_error)
  {
    const double force = last.history->peak().force;
    const auto  &bar   = last.peak_force_bar;
    std::string  text = with_error(force, bar ? bar->total() * force : 0., "N");
    if (force == 0.)
      return text;
    if (!bar)
      return text + ", error not known";
    return text + " (mesh, step)" +
      (model_error ? " ± " + error_in_words(*model_error * force, "N") +
           " (model, from comparisons)" :
                     ", error of the model not known");
  }



  Trust
  Verdict::trust() const
  {
    return std::max(convergence.trust, model.trust);
  }



  Verdict
  verdict_of(const Parameters  &parameters,
             const Outcome      outcome,
             const CycleResult &last,
             const Warnings    &warnings)
  {
    Verdict verdict;
    if (!last.history)
      {
        verdict.text = "nothing strikes the plate";
        return verdict;
      }
    verdict.warnings = warnings;
    verdict.force    = force_in_words(last, warnings.model_error());
    verdict.text = verdict.force + ": " + result_in_words(parameters, outcome);
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



  std::string
  model_in_words(const Verdict &verdict)
  {
    if (verdict.warnings.model.empty())
      return std::string("Within the limits of the model") +
        (verdict.warnings.assumes_elastic_contact ?
           ", elastic contact assumed" :
           "");
    return verdict.model.trust == Trust::doubtful ? "Outside the limits of the "
                                                    "model" :
                                                    "Far outside the limits of "
                                                    "the model";
  }
} // namespace PlateImpact
