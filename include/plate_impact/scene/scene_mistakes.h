#ifndef plate_impact_scene_scene_mistakes_h
#define plate_impact_scene_scene_mistakes_h

#include "plate_impact/scene/scene_schema.h"

#include <set>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// Mistakes in entries that are allowed by themselves and do not fit
  /// together.
  class SceneMistakes
  {
  public:
    /// @param schema  must outlive the mistakes
    /// @param swept   entries that have no value yet: what involves them is not
    ///                judged
    SceneMistakes(const SceneSchema           &schema,
                  const std::set<std::string> &swept);

    /// Adds a mistake in the value of the first entry, unless one of those
    /// involved is swept or has been refused before. Its place is that of the
    /// first of them which the scene sets.
    void
    refuse(const std::vector<std::string> &involved, const std::string &text);

    bool
    is_swept(const std::string &path) const;

    std::vector<std::string> sentences;

  private:
    const SceneSchema          &schema;
    const std::set<std::string> swept;
  };
} // namespace PlateImpact

#endif
