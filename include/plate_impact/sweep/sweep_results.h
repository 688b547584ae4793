#pragma once

#include "plate_impact/contact/contact_history.h"
#include "plate_impact/scene/scene.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What was made for a point of a sweep, or for all.
  struct SweepWork
  {
    unsigned int meshes = 0; ///< adapted ones with those before them
    unsigned int plates = 0; ///< models that points were computed on
    unsigned int loads  = 0; ///< responses or reductions
  };


  /// What became of a point.
  struct SweepRow
  {
    std::size_t         point = 0;
    std::vector<double> quantities;    ///< NaN: none; empty for a failed point
    std::string         failure;       ///< the reason, in one line
    std::vector<std::string> warnings; ///< a sentence each, as of `run`
    ContactHistory           history;  ///< without states: not wanted
    SweepWork                work = {};

    /// For the way from one process to another.
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &point &quantities &failure &warnings &history;
      archive &work.meshes &work.plates &work.loads;
    }
  };


  /// How many points of a sweep failed, and how many have warnings that differ
  /// in their numbers only, with the first of each kind.
  std::vector<std::string>
  sweep_warnings(const std::vector<std::optional<SweepRow>> &rows);

  /// sweep.html: the range of the force, the quantities of the points over the
  /// swept values, histories and the table.
  /// @param rows       of all points
  /// @param histories  of some points
  std::string
  sweep_page(const SweepScene                            &scene,
             const std::vector<std::optional<SweepRow>>  &rows,
             const std::map<std::size_t, ContactHistory> &histories,
             const SweepWork                             &work);
} // namespace PlateImpact
