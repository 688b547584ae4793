#pragma once

#include "plate_impact/scene/scene.h"

#include <cstddef>
#include <vector>

namespace PlateImpact
{
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

    /// Parts of groups to compute one after another: points that are still to
    /// be computed, at most so many.
    struct Task
    {
      std::size_t              group;
      std::vector<std::size_t> points;
    };

    /// @param to_do  by point
    std::vector<Task>
    tasks(const std::vector<bool> &to_do, std::size_t most_points) const;

    std::vector<std::vector<std::size_t>> groups; ///< of points

    /// Loads with time steps, as the swept entries tell them apart, in all
    /// groups together.
    std::size_t n_loads;
  };
} // namespace PlateImpact
