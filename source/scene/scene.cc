#include "plate_impact/scene/scene.h"

#include "plate_impact/base/text.h"
#include "plate_impact/scene/scene_checker.h"
#include "plate_impact/scene/scene_reader.h"
#include "plate_impact/scene/sweep_plan.h"

namespace PlateImpact
{
  Scene
  read_scene(const std::string                &path,
             const std::vector<std::string>   &overrides,
             const std::optional<std::string> &output)
  {
    SceneReader  reader(path, overrides, output);
    SceneChecker checker(reader.schema, reader.parameters());
    checker.check_together();
    Parameters given = reader.parameters();
    given.plate.file = checker.parameters().plate.file;
    if (reader.mistakes.empty() && checker.mistakes.sentences.empty())
      checker.complete();
    reader.add_mistakes(checker.mistakes.sentences);
    reader.add_mistakes(SweepPlan(reader.schema, given.sweep).mistakes());
    reader.refuse_mistakes();
    return {printable(path), checker.parameters(), reader.text(), given};
  }



  void
  print_defaults(std::ostream &out)
  {
    SceneReader().schema.print(out, /*with_documentation=*/true);
  }
} // namespace PlateImpact
