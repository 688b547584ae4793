#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact_history.h"
#include "plate_impact/contact/zener.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// What is known of an impact before it is paid for: from a coarse mesh, or,
  /// where that does not carry the waves, from Zener's infinite plate until
  /// waves are back from the edges.
  struct Expectation
  {
    /// @param parameters  of a scene with an impactor
    explicit Expectation(const Parameters &parameters);

    /// What a run is to cost that reaches its target.
    struct Cost
    {
      double cells; ///< of the last mesh
      double steps; ///< on a mesh
    };

    /// About: of an adaptive run from its first two meshes, which it computes.
    /// On the scenes of prm/ mostly right to a factor of two. Small targets are
    /// said to cost too much, one of 0.5 % seventeen times as many cells as it
    /// did. Seconds cannot be said as well: per unknown and cycle they differ
    /// by a hundred between scenes.
    /// @throws ComputationError when these meshes cannot be computed
    /// @throws Interruption, between two steps
    Cost
    cost(const Parameters &parameters) const;

    /// How many times the fastest waves have come back from the nearest edge
    /// before the peak, where that is many: the slower ones that carry the
    /// force are then back a few times.
    std::optional<double>
    crossings_before_peak(const Parameters &parameters) const;

    ZenerImpact zener; ///< on the infinite plate

    ContactHistory        history;          ///< up to the scene's end at most
    std::optional<double> contact_end;      ///< of the impact [s]
    double                until = 0.;       ///< when what is known ends [s]
    std::string           source;           ///< where it comes from
    bool                  is_bound = false; ///< whether the force is larger

    std::vector<std::string> warnings; ///< as model_warnings()
    std::string              contact;  ///< as Warnings::contact
  };


  /// The lowest natural frequencies of the plate, whatever strikes it, on a
  /// coarse mesh: see natural_frequencies(). [Hz]
  std::vector<double>
  expected_frequencies(const Parameters &parameters);


  /// Shortest way from the load to an edge. [m]
  double
  distance_to_edge(const Parameters &parameters);
} // namespace PlateImpact
