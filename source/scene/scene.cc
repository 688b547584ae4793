#include "plate_impact/scene/scene.h"

#include "plate_impact/base/text.h"
#include "plate_impact/scene/scene_checker.h"
#include "plate_impact/scene/scene_reader.h"
#include "plate_impact/scene/sweep_scene.h"

namespace PlateImpact
{
  Scene
  read_scene(const std::string                &path,
             const std::vector<std::string>   &overrides,
             const std::optional<std::string> &output)
  {
    SceneReader      reader(path, overrides, output);
    SceneChecker     checker(reader);
    const Parameters given = checker.parameters;
    checker.complete();
    const SweepPlan sweep(reader);
    reader.refuse_mistakes();
    Scene scene{printable(path),
                checker.parameters,
                reader.entries.text(/*with_meanings=*/false),
                given,
                checker.expected,
                sweep,
                {}};
    for (const Entry &entry : reader.entries.all)
      scene.inputs.push_back({entry.path, entry.text()});
    return scene;
  }



  void
  print_defaults(std::ostream &out)
  {
    out << SceneReader().entries.text(/*with_meanings=*/true);
  }
} // namespace PlateImpact
