#pragma once

#include "plate_impact/base/entries.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/scene/scene_file.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// A scene file and what the command line sets on top of it, every value
  /// checked by itself.
  struct SceneReader
  {
    /// The defaults.
    explicit SceneReader(const std::string &path = "")
      : name(path)
    {
      parameters.plate.declare_entries(entries);
      parameters.impactor.declare_entries(entries);
      parameters.contact.declare_entries(entries);
      parameters.discretization.declare_entries(entries);
      parameters.time.declare_entries(entries);
      parameters.adaptivity.declare_entries(entries);
      parameters.output.declare_entries(entries);
      parameters.comparison.declare_entries(entries);
      parameters.sweep.declare_entries(entries);
    }

    SceneReader(const std::string                &path,
                const std::vector<std::string>   &overrides,
                const std::optional<std::string> &output);

    SceneReader(const SceneReader &) = delete;

    /// Sets entries, those that cannot be are mistakes. A file that one names
    /// is looked for beside the scene first. Those of a section that does not
    /// exist are passed over: the section is the one mistake.
    void
    set(const std::vector<Assignment> &assignments);

    /// Adds a mistake in the value of an entry.
    void
    refuse(const Entry &entry, const std::string &text)
    {
      mistakes.push_back(entry.origin + ": " + entry.path + " = " +
                         entry.text() + ' ' + text);
    }

    /// The sentence for a section or an entry of it that does not exist.
    std::string
    unknown(const std::string &section, const std::string &entry) const;

    /// @throws InputError with the mistakes in the order of the lines of the
    ///         file, unless there are none
    void
    refuse_mistakes();

    const std::string        name; ///< of the file, as given
    Parameters               parameters;
    Entries                  entries;  ///< of the parameters
    std::vector<std::string> mistakes; ///< a sentence each
  };
} // namespace PlateImpact
