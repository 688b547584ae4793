#include "plate_impact/scene/sweep_scene.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/scene/scene_checker.h"

namespace PlateImpact
{
  SweepScene::SweepScene(const std::string                &path,
                         const std::vector<std::string>   &overrides,
                         const std::optional<std::string> &output)
    : reader(path, overrides, output)
    , name(printable(path))
    , plan(reader.entries, reader.parameters.sweep)
  {
    for (const SweptEntry &swept : plan.entries)
      {
        Entry &entry = reader.entries.at(swept.path);
        if (entry.origin == "--set")
          reader.add_mistakes({"--set: " + entry.path + " = " + entry.value +
                               " has no meaning: the entry is swept"});
        entry.origin   = swept.origin;
        entry.is_known = false;
      }
    SceneChecker checker(reader.entries, reader.parameters);
    reader.add_mistakes(checker.mistakes);
    reader.add_mistakes(plan.mistakes);
    if (reader.mistakes.empty() && plan.n_points == 0)
      reader.add_mistakes(
        {path +
         ": nothing is swept; expected Sweep/Entry 1 and Values 1, for "
         "example Impactor/Velocity and 1, 2, 5"});
    reader.refuse_mistakes();

    text       = reader.entries.text(/*with_meanings=*/false);
    parameters = checker.parameters;
  }



  SweepPoint
  SweepScene::point(const std::size_t index)
  {
    std::vector<Assignment>        assignments;
    const std::vector<std::string> values = plan.values(index);
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        const SweptEntry &swept = plan.entries[i];
        const std::size_t slash = swept.path.find('/');
        assignments.push_back({swept.path.substr(0, slash),
                               swept.path.substr(slash + 1),
                               values[i],
                               swept.origin});
      }
    for (Entry &entry : reader.entries.all)
      entry.chosen.reset();
    std::vector<std::string> mistakes = reader.set(assignments);

    reader.parameters.plate.file = parameters.plate.file;
    SceneChecker checker(reader.entries, reader.parameters);
    if (mistakes.empty())
      {
        checker.complete();
        mistakes = checker.mistakes;
      }
    if (mistakes.empty() && !checker.expected)
      mistakes = {plan.entries.front().origin + ": there is no impactor"};
    if (!mistakes.empty())
      throw InputError(mistakes);
    return {checker.parameters, *checker.expected};
  }
} // namespace PlateImpact
