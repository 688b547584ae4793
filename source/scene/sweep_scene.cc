#include "plate_impact/scene/sweep_scene.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/scene/scene_checker.h"

#include <set>

namespace PlateImpact
{
  SweepScene::SweepScene(const std::string                &path,
                         const std::vector<std::string>   &overrides,
                         const std::optional<std::string> &output)
    : reader(path, overrides, output)
    , sweep_plan(reader.schema, reader.parameters().sweep)
  {
    std::set<std::string> swept;
    for (const SweptEntry &entry : sweep_plan.entries())
      {
        swept.insert(entry.path);
        if (reader.schema.origin(entry.path) == "--set")
          reader.add_mistakes({"--set: " + entry.path + " = " +
                               reader.schema.value(entry.path) +
                               " has no meaning: the entry is swept"});
      }
    SceneChecker checker(reader.schema, reader.parameters(), swept);
    checker.check_together();
    reader.add_mistakes(checker.mistakes.sentences);
    reader.add_mistakes(sweep_plan.mistakes());
    if (reader.mistakes.empty() && sweep_plan.n_points() == 0)
      reader.add_mistakes(
        {path +
         ": nothing is swept; expected Sweep/Entry 1 and Values 1, for "
         "example Impactor/Velocity and 1, 2, 5"});
    reader.refuse_mistakes();

    base_text = reader.text();
    base      = reader.parameters();

    base->plate.file = checker.parameters().plate.file;
  }



  const SweepPlan &
  SweepScene::plan() const
  {
    return sweep_plan;
  }



  const Parameters &
  SweepScene::parameters() const
  {
    return *base;
  }



  bool
  SweepScene::may_adapt() const
  {
    return base->adaptivity.is_adaptive() ||
      sweep_plan.sweeps("Adaptivity/Strategy");
  }



  std::string
  SweepScene::name() const
  {
    return printable(reader.name);
  }



  const std::string &
  SweepScene::text() const
  {
    return base_text;
  }



  SweepPoint
  SweepScene::point(const std::size_t index)
  {
    reader.schema.take_back_choices();
    std::vector<Assignment>        assignments;
    const std::vector<std::string> values = sweep_plan.values(index);
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        const SweptEntry &swept = sweep_plan.entries()[i];
        const std::size_t slash = swept.path.find('/');
        assignments.push_back({swept.path.substr(0, slash),
                               swept.path.substr(slash + 1),
                               values[i],
                               swept.origin});
        reader.locate(assignments.back());
      }

    std::vector<std::string> mistakes   = reader.schema.set(assignments);
    const auto               known      = expected_peaks.find(index);
    Parameters               parameters = reader.parameters();
    parameters.plate.file               = base->plate.file;
    SceneChecker checker(reader.schema,
                         parameters,
                         /*swept=*/{},
                         known == expected_peaks.end() ?
                           std::nullopt :
                           std::optional(known->second));
    if (mistakes.empty())
      {
        checker.check_together();
        if (checker.mistakes.sentences.empty())
          checker.complete();
        mistakes = checker.mistakes.sentences;
      }
    if (mistakes.empty() && !checker.expected_peak)
      mistakes = {sweep_plan.entries().front().origin +
                  ": there is no impactor"};
    if (!mistakes.empty())
      throw InputError(mistakes);
    expected_peaks.try_emplace(index, *checker.expected_peak);
    return {checker.parameters(), *checker.expected_peak};
  }
} // namespace PlateImpact
