#pragma once

#include <deal.II/grid/tria.h>

#include "plate_impact/base/parameters.h"
#include "plate_impact/plate/plate_discretization.h"
#include "plate_impact/plate/plate_element.h"
#include "plate_impact/transient/loaded_plate.h"

#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace PlateImpact
{
  /// A plate on one mesh that is struck by one impactor after another. What the
  /// impactor does not change is made once, when it is first needed.
  class PlateModel
  {
  public:
    /// Numbers the unknowns.
    /// @param mesh  of the part of the plate that symmetry leaves
    PlateModel(const PlateParameters                    &plate,
               const DiscretizationParameters           &discretization,
               std::unique_ptr<dealii::Triangulation<2>> mesh);

    /// @param impact        with this plate and discretization
    /// @param needs_states  whether displacements are to be right, too
    LoadedPlate
    under(const Parameters &impact, bool needs_states);

    /// As SemidiscreteSystem::static_compliance(), under its load. [m/N]
    double
    static_compliance(const Parameters &impact)
    {
      return loaded_mesh(impact)->system.static_compliance();
    }

    /// As the function of that name. [Hz]
    std::vector<double>
    natural_frequencies(unsigned int n);

    const PlateDiscretization &
    discretization() const
    {
      return plate;
    }

    PlateWork
    work() const
    {
      return matrices == nullptr ? PlateWork() : matrices->work;
    }

  private:
    /// All of an impact that a load depends on, and its steps.
    using MeshKey = std::tuple<LoadShape,
                               double, // patch radius
                               LocalResponse,
                               ImpactorShape,
                               double>; // length of a cylinder
    using LoadKey = std::tuple<MeshKey,
                               ForceIntegration,
                               TimeParameters, // to the end of the vectors
                               bool>;          // needs states

    static MeshKey
    mesh_key(const Parameters &impact)
    {
      return {impact.contact.load_distribution,
              impact.contact.patch_radius,
              impact.contact.local_response,
              impact.impactor.shape,
              impact.impactor.length};
    }

    const std::shared_ptr<EffectiveStiffness> &
    assembled();
    const std::shared_ptr<LoadedMesh> &
    loaded_mesh(const Parameters &impact);

    const PlateElement                              element;
    const std::unique_ptr<dealii::Triangulation<2>> mesh;
    const SolverType                                linear_solver;
    const double                                    loss_factor;
    PlateDiscretization                             plate;

    std::shared_ptr<EffectiveStiffness>            matrices; ///< of assembled()
    std::map<MeshKey, std::shared_ptr<LoadedMesh>> loaded_meshes;
    std::map<LoadKey, std::shared_ptr<RitzReduction>> reductions;
    unsigned int                                      n_forgotten_vectors = 0;
  };


  /// The scene with an end time: its own or, where that is 0, the end of the
  /// impact on this plate (ContactHistory::end_of_impact). That is looked for
  /// up to twice the time in which a massless plate throws the impactor back,
  /// and 2^18 steps.
  /// @param needs_states  as for under()
  /// @param expected      end from which on it is looked for, 0: any [s]
  /// @throws ComputationError naming step and quantity
  Parameters
  until_contact_ends(PlateModel       &plate,
                     const Parameters &impact,
                     bool              needs_states,
                     double            expected = 0.);
} // namespace PlateImpact
