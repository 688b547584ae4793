#include "plate_impact/scene/scene_mistakes.h"

namespace PlateImpact
{
  SceneMistakes::SceneMistakes(const SceneSchema           &schema,
                               const std::set<std::string> &swept)
    : schema(schema)
    , swept(swept)
  {}



  void
  SceneMistakes::refuse(const std::vector<std::string> &involved,
                        const std::string              &text)
  {
    std::string origin = "default";
    for (const std::string &path : involved)
      {
        if (is_swept(path) || schema.was_refused(path))
          return;
        if (origin == "default")
          origin = schema.origin(path);
      }
    sentences.push_back(origin + ": " + involved.front() + " = " +
                        schema.value(involved.front()) + " " + text);
  }



  bool
  SceneMistakes::is_swept(const std::string &path) const
  {
    return swept.count(path) > 0;
  }
} // namespace PlateImpact
