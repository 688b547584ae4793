#include "plate_impact/output/verdict.h"

#include "plate_impact/base/text.h"

#include <algorithm>

namespace PlateImpact
{
  template <>
  const std::vector<std::pair<Trust, std::string>> &
  choices()
  {
    static const std::vector<std::pair<Trust, std::string>> words = {
      {Trust::good, "good"},
      {Trust::doubtful, "doubtful"},
      {Trust::none, "none"}};
    return words;
  }



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



    /// What the mesh has in place of its target.
    std::string
    missed_target(const Parameters &parameters, const CycleResult &last)
    {
      const AdaptivityParameters &adaptivity = parameters.adaptivity;
      if (adaptivity.goal == AdaptationGoal::peak_force)
        return last.peak_force_bar ? "the peak force is known to " +
            about_percentage(last.peak_force_bar->total()) + ", wanted to " +
            percentage(adaptivity.target()) :
                                     "";
      if (!last.error)
        return "";
      if (last.error->eta > adaptivity.target_error)
        return "eta is " + percentage(last.error->eta) + ", wanted " +
          percentage(adaptivity.target_error);
      return "eta is met, but the largest xi' is " +
        about(last.over_limit->max_element()) + ", wanted below 1";
    }



    bool
    adapts_in_vain(const Outcome outcome)
    {
      return outcome != Outcome::target_reached &&
        outcome != Outcome::single_mesh;
    }
  } // namespace



  Verdict
  verdict_of(const Parameters               &parameters,
             const Outcome                   outcome,
             const CycleResult              &last,
             const std::vector<std::string> &warnings)
  {
    Verdict    verdict;
    const auto lower = [&verdict](const Trust trust, const std::string &why) {
      verdict.trust = std::max(verdict.trust, trust);
      if (!why.empty())
        verdict.reasons.push_back(why);
    };
    if (!last.history)
      {
        verdict.text = "nothing strikes the plate";
        return verdict;
      }
    const double force = last.history->peak().force;
    verdict.text =
      with_error(force,
                 last.peak_force_bar ? last.peak_force_bar->total() * force :
                                       0.,
                 "N");
    if (!last.peak_force_bar && !parameters.contact.load_is_singular())
      verdict.text += ", error not known";
    verdict.text += ": " + result_in_words(parameters, outcome);

    if (adapts_in_vain(outcome))
      lower(Trust::doubtful, missed_target(parameters, last));
    if (outcome == Outcome::single_mesh && !parameters.adaptivity.is_adaptive())
      lower(Trust::doubtful, "the mesh was not made for a target");
    if (parameters.contact.load_is_singular())
      lower(Trust::doubtful,
            "under a point load the peak force has no limit: it is that of "
            "the smallest cell");
    else if (last.peak_force_error && !last.peak_force_bar)
      lower(Trust::none,
            "the mesh does not see the waves that the contact sends out, or "
            "not the load, or the step is too coarse to tell its error: "
            "there is no bar");
    else if (!last.peak_force_bar)
      lower(Trust::doubtful, "no error was estimated");
    else if (last.peak_force_bar->total() > 0.05)
      lower(Trust::doubtful, "the error may be more than a twentieth");
    if (last.history->relative_energy_drift() > 0.1)
      lower(Trust::none,
            "the total energy changes by " +
              about_percentage(last.history->relative_energy_drift()));
    if (!warnings.empty())
      lower(Trust::doubtful, "see " + counted(warnings.size(), "warning"));
    return verdict;
  }
} // namespace PlateImpact
