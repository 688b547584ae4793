#pragma once

#include "plate_impact/base/entries.h"
#include "plate_impact/base/parameters.h"

#include <cstddef>
#include <string>
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
  ///
  /// Values that are no number where the entry holds one, or no word that it
  /// knows, are mistakes of the scene; numbers beyond what an entry allows only
  /// make their points invalid.
  struct SweepPlan
  {
    /// Points beyond this number are refused.
    static constexpr std::size_t max_points = 1000000;

    SweepPlan(const Entries &entries, const SweepParameters &sweep);

    /// Whether an entry, "Section/Entry", is swept.
    bool
    sweeps(const std::string &path) const;

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
    names() const;

    /// The value of every entry at a point. In a product the values of the last
    /// entry change fastest.
    std::vector<std::string>
    values(std::size_t point) const;

    std::vector<SweptEntry>  entries;
    std::vector<std::string> mistakes; ///< a sentence each

    /// Every value with every other, as opposed to lists that are paired up.
    bool        is_product;
    std::size_t n_points = 0; ///< 0 without an entry

  private:
    void
    read_entry(unsigned int           n,
               const Entries         &all,
               const SweepParameters &sweep);
    void
    combine(const Entries &all);
  };
} // namespace PlateImpact
