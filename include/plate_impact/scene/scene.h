#pragma once

#include "plate_impact/contact/zener.h"
#include "plate_impact/scene/scene_reader.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace PlateImpact
{
  /// An entry of the scene and the values that it takes in a sweep.
  struct SweptEntry
  {
    std::string              path;   ///< Section/Entry
    std::string              unit;   ///< "m/s", "-" for pure numbers, or empty
    std::string              origin; ///< of the values, "scene.prm:12"
    std::vector<std::string> values;
  };


  /// The points of a sweep: the swept entries and how their values combine.
  struct SweepPlan
  {
    /// Points beyond this number are refused.
    static constexpr std::size_t max_points = 1000000;

    /// Adds to the reader's mistakes values that are no number where the entry
    /// holds one, or no word that it knows; numbers beyond what an entry allows
    /// only make their points invalid.
    explicit SweepPlan(SceneReader &reader);

    /// Whether an entry, "Section/Entry", is swept.
    bool
    sweeps(const std::string &path) const
    {
      for (const SweptEntry &entry : entries)
        if (entry.path == path)
          return true;
      return false;
    }

    /// Whether points may adapt their mesh.
    /// @param parameters  of what is not swept
    bool
    may_adapt(const Parameters &parameters) const
    {
      return parameters.adaptivity.is_adaptive() ||
        sweeps("Adaptivity/Strategy");
    }

    /// Their paths, for a sentence.
    std::string
    names() const
    {
      std::string text;
      for (const SweptEntry &entry : entries)
        text += (text.empty() ? "" : ", ") + entry.path;
      return text;
    }

    /// The value of every entry at a point. In a product the values of the last
    /// entry change fastest.
    std::vector<std::string>
    values(std::size_t point) const
    {
      std::vector<std::string> result(entries.size());
      for (std::size_t i = entries.size(); i-- > 0;)
        {
          const std::vector<std::string> &values = entries[i].values;
          result[i] = values[is_product ? point % values.size() : point];
          point     = is_product ? point / values.size() : point;
        }
      return result;
    }

    std::vector<SweptEntry> entries;

    /// Every value with every other, as opposed to lists that are paired up.
    bool        is_product;
    std::size_t n_points = 0; ///< 0 without an entry, or with mistakes
  };


  /// Points of a sweep that share a plate on one mesh, those with the same load
  /// and time steps next to each other. What a point is made for follows from
  /// the names of the swept entries:
  /// - the impactor and the contact law: nothing else changes; but the shear
  ///   stiffness of a laminate follows the law;
  /// - other entries of the contact and the time: the load or the response;
  /// - everything else: the plate, its mesh or what the mesh adapts to.
  ///
  /// A mesh that adapts depends on the load and the time as well, so that
  /// adaptive points share a mesh only where both are the same.
  struct SweepGroups
  {
    /// @param parameters  of what is not swept
    SweepGroups(const SweepPlan &plan, const Parameters &parameters);

    std::vector<std::vector<std::size_t>> groups; ///< of points

    std::size_t n_loads; ///< with their time steps, in all groups together
  };


  /// A scene that has passed every check.
  struct Scene
  {
    std::string name; ///< of the file, printable
    Parameters  parameters;
    std::string text;  ///< every value used, as a scene that repeats the run
    Parameters  given; ///< with the zeros that let the program choose
    std::optional<ZenerImpact> expected; ///< of an impactor
    SweepPlan                  sweep;
    std::vector<std::pair<std::string, std::string>>
      inputs; ///< entries by their paths, with the values used
  };

  /// Reads a scene file, on top of it the overrides "Section/Entry=value" and
  /// the output directory of the command line, checks the entries, and replaces
  /// zeros that mean "chosen by the program" by what is chosen.
  /// @throws InputError with every mistake found: file, line, entry, value and
  ///         what is allowed
  Scene
  read_scene(const std::string                &path,
             const std::vector<std::string>   &overrides,
             const std::optional<std::string> &output = {});


  /// A point of a sweep that has passed every check.
  struct SweepPoint
  {
    Parameters  parameters;
    ZenerImpact expected;
  };


  /// A scene whose entries are swept. The file is read once; a point is the
  /// scene with its values in place, checked and completed as by read_scene().
  class SweepScene
  {
    SceneReader reader; // before what is read by it

  public:
    /// @throws InputError with every mistake that is not one of single points
    SweepScene(const std::string                &path,
               const std::vector<std::string>   &overrides,
               const std::optional<std::string> &output);

    /// @throws InputError when its values are not valid together, or without an
    ///         impactor
    SweepPoint
    point(std::size_t index);

    const std::string name; ///< of the file, printable
    const SweepPlan   plan;
    Parameters        parameters; ///< the points' values left out
    std::string       text; ///< every value, as a scene that repeats the sweep
  };
} // namespace PlateImpact
