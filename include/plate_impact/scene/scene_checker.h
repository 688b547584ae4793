#ifndef plate_impact_scene_scene_checker_h
#define plate_impact_scene_scene_checker_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/scene/scene_mistakes.h"
#include "plate_impact/scene/scene_schema.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// Checks values that are each allowed by themselves, and fills in those
  /// that the program chooses.
  class SceneChecker
  {
  public:
    /// @param schema  must outlive the checker
    /// @param swept   entries that have no value yet: what involves them is not
    ///                judged
    /// @param expected_peak  where it is known already
    SceneChecker(SceneSchema                       &schema,
                 const Parameters                  &parameters,
                 const std::set<std::string>       &swept         = {},
                 const std::optional<ExpectedPeak> &expected_peak = {});

    /// Entries against each other, with words in place of those not given that
    /// follow from others.
    void
    check_together();

    /// Replaces zeros that mean "chosen by the program", and checks what is
    /// chosen.
    void
    complete();

    /// Those given, and what complete() has chosen.
    const Parameters &
    parameters() const;

    SceneMistakes mistakes;

    /// By Zener's equation; empty without an impactor or before complete().
    std::optional<ExpectedPeak> expected_peak;

  private:
    /// Fills an entry in.
    /// @param variable  of the scene that holds its value
    void
    choose(const std::string &section,
           const std::string &entry,
           double            &variable,
           double             value);

    /// The same with a word, unless the scene gives the entry.
    template <typename Choice>
    void
    choose_unless_given(const std::string &entry,
                        Choice            &variable,
                        Choice             value);

    /// Law, load and local response that fit the rest of the scene, where they
    /// are not given.
    void
    choose_contact();

    void
    check_unloading();
    void
    check_contact();
    void
    check_time();
    void
    check_mesh();
    void
    check_goal();
    void
    check_comparison();

    void
    complete_impactor();
    void
    complete_time(const ExpectedPeak &peak);
    void
    complete_contact(const ExpectedPeak &peak);
    /// Refuses a force that the local response of a layer does not hold.
    void
    check_layer(const ExpectedPeak &peak, bool radius_is_given);
    void
    complete_mesh();

    SceneSchema &schema;
    Parameters   scene;
  };
} // namespace PlateImpact

#endif
