#pragma once

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/scene/scene.h"
#include "plate_impact/sweep/sweep_results.h"
#include "plate_impact/transient/plate_model.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
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

    std::size_t n_loads; ///< with their time steps, in all groups together
  };


  /// Computes points of a sweep, those of one group after another on one struck
  /// plate: if adaptive, on the last mesh of the worst, the one with the
  /// shortest contact in Zener's equation, then with the largest force.
  class SweepComputation
  {
  public:
    /// Both must outlive the computation.
    SweepComputation(SweepScene &scene, const SweepGroups &groups)
      : scene(scene)
      , groups(groups)
    {}

    /// Whatever goes wrong becomes the failure of the row.
    /// @param group  that the point belongs to
    SweepRow
    compute(std::size_t group, std::size_t point);

  private:
    /// With its warnings, without those of a shared mesh.
    using Computed = std::pair<CycleResult, std::vector<std::string>>;

    Computed
    compute(std::size_t group, const SweepPoint &point);
    /// The impact on the struck plate.
    Computed
    strike(const SweepPoint &point);
    /// The mesh of a group, made for the worst of its valid points.
    std::unique_ptr<dealii::Triangulation<2>>
    make_mesh(std::size_t group, const SweepPoint &point);
    /// With the error, and on better meshes where the parameters say so.
    Computed
    analyse(const Parameters                         &parameters,
            std::unique_ptr<dealii::Triangulation<2>> mesh);

    SweepScene        &scene;
    const SweepGroups &groups;

    SweepWork                   work; ///< since the last point
    std::optional<std::size_t>  current_group;
    double                      min_cell_size = 0.; ///< of its mesh [m]
    std::unique_ptr<PlateModel> plate_model;        ///< of the current group
    std::string                 failure;            ///< why there is none
    std::vector<std::string>    mesh_warnings;      ///< of its mesh
  };
} // namespace PlateImpact
