#ifndef plate_impact_scene_scene_reader_h
#define plate_impact_scene_scene_reader_h

#include "plate_impact/base/parameters.h"
#include "plate_impact/scene/scene_schema.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// A scene file and what the command line sets on top of it, every value
  /// checked by itself.
  class SceneReader
  {
  public:
    /// The defaults.
    SceneReader();

    SceneReader(const std::string                &path,
                const std::vector<std::string>   &overrides,
                const std::optional<std::string> &output);

    SceneReader(const SceneReader &) = delete;

    /// A file that an entry names is looked for beside the scene first.
    void
    locate(Assignment &assignment) const;

    void
    add_mistakes(const std::vector<std::string> &more);

    /// @throws InputError with the mistakes in the order of the lines of the
    ///         file, unless there are none
    void
    refuse_mistakes();

    /// The values that the entries have now.
    Parameters
    parameters() const;

    /// Every value, as a scene.
    std::string
    text() const;

    const std::string        name; ///< of the file, as given
    SceneSchema              schema;
    std::vector<std::string> mistakes;

  private:
    /// The results must not replace the scene.
    void
    check_directory();

    Parameters bound; ///< to the schema, which changes it
  };
} // namespace PlateImpact

#endif
