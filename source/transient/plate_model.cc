#include "plate_impact/transient/plate_model.h"

#include <deal.II/base/timer.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/natural_frequencies.h"

#include <algorithm>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Numbers in the Ritz vectors of all loads that are kept: 0.8 GB.
    constexpr double most_kept_numbers = 1e8;



    /// Of the plate without damping. [rad/s]
    double
    first_frequency(EffectiveStiffness &matrices)
    {
      const std::vector<double> frequencies = natural_frequencies(matrices, 1);
      if (frequencies.empty())
        throw ComputationError(
          "the mesh has too few unknowns for the first natural frequency, to "
          "which Plate/Loss factor refers; choose more Discretization/Initial "
          "cells");
      return 2. * std::acos(-1.) * frequencies.front();
    }
  } // namespace



  PlateModel::PlateModel(const PlateParameters          &plate,
                         const DiscretizationParameters &discretization,
                         std::unique_ptr<dealii::Triangulation<2>> part)
    : element(discretization.element, PlateSection(plate).stretching)
    , mesh(std::move(part))
    , linear_solver(discretization.linear_solver)
    , loss_factor(plate.loss_factor)
    , plate(*mesh, element, plate)
  {}



  LoadedPlate
  PlateModel::under(const Parameters &impact, const bool needs_states)
  {
    TimeParameters time = impact.time;
    time.end_time       = std::max(time.end_time, time.end_of_vectors);
    const LoadKey key(mesh_key(impact),
                      impact.contact.integration,
                      time,
                      needs_states);
    if (reductions.count(key) == 0)
      {
        forget_loads();
        reductions[key] =
          std::make_shared<RitzReduction>(loaded_mesh(impact),
                                          time,
                                          impact.contact.integration,
                                          needs_states);
        ++n_loads;
      }
    return {impact, reductions[key]};
  }



  PlateModel::MeshKey
  PlateModel::mesh_key(const Parameters &impact)
  {
    return {impact.contact.load_distribution,
            impact.contact.patch_radius,
            impact.contact.local_response,
            impact.impactor.shape,
            impact.impactor.length};
  }



  const std::shared_ptr<LoadedMesh> &
  PlateModel::loaded_mesh(const Parameters &impact)
  {
    std::shared_ptr<LoadedMesh> &result = loaded_meshes[mesh_key(impact)];
    if (result != nullptr)
      return result;
    assembled();
    const dealii::Timer      timer;
    const ContactParameters &contact = impact.contact;
    const double             finest_cell =
      cell_sizes_near_load(*mesh,
                           impact.impactor.contact_half_length(),
                           contact.has_patch() ? contact.patch_radius : 0.)
        .first;
    const auto points = on_meshed_part(
      make_load_distribution(contact, impact.impactor.length, finest_cell),
      impact.plate);
    result = std::make_shared<LoadedMesh>(LoadedMesh{
      {matrices,
       plate.load(points, load_rotation_factor(impact.plate, contact))},
      {}});
    assembly_seconds += timer.wall_time();
    return result;
  }



  std::vector<double>
  PlateModel::natural_frequencies(const unsigned int n)
  {
    if (n == 0)
      return {};
    return PlateImpact::natural_frequencies(*assembled(), n);
  }



  const std::shared_ptr<EffectiveStiffness> &
  PlateModel::assembled()
  {
    if (matrices == nullptr)
      {
        const dealii::Timer timer;
        plate.assemble();
        matrices = std::make_shared<EffectiveStiffness>(plate, linear_solver);
        if (loss_factor > 0.)
          matrices->damping = loss_factor / first_frequency(*matrices);
        // without what the search for the frequency took to factorize
        assembly_seconds +=
          timer.wall_time() - matrices->work().factorization_seconds;
      }
    return matrices;
  }



  void
  PlateModel::forget_loads()
  {
    double numbers = 0.;
    for (const auto &[key, loaded] : loaded_meshes)
      numbers += 1. * loaded->n_vectors() * loaded->system.load().size();
    if (numbers <= most_kept_numbers)
      return;
    for (const auto &[key, loaded] : loaded_meshes)
      n_forgotten_vectors += loaded->n_vectors();
    reductions.clear();
    loaded_meshes.clear();
  }



  PlateModel::Work
  PlateModel::work() const
  {
    Work work;
    work.loads            = n_loads;
    work.ritz_vectors     = n_forgotten_vectors;
    work.assembly_seconds = assembly_seconds;
    for (const auto &[key, loaded] : loaded_meshes)
      work.ritz_vectors += loaded->n_vectors();
    if (matrices != nullptr)
      static_cast<SolverWork &>(work) = matrices->work();
    return work;
  }
} // namespace PlateImpact
