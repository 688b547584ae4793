#include "plate_impact/transient/plate_model.h"

#include <deal.II/base/timer.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/natural_frequencies.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Steps in which the end of a contact is looked for.
    constexpr double most_steps_of_contact = 262144.;



    /// How long an impact may last.
    struct ContactTime
    {
      double shortest; ///< expected [s]
      double longest;  ///< that is waited for [s]
      bool   is_held;  ///< whether the plate throws the impactor back
    };

    ContactTime
    contact_time(const Parameters  &impact,
                 const ZenerImpact &expected,
                 const double       compliance)
    {
      const double of_zener   = 1.5 * expected.contact_time(),
                   half_space = 2. * expected.peak_on_rigid_plate().time;
      if (!std::isfinite(compliance)) // free to move, it is left sooner
        return {of_zener, 100. * half_space, false};
      const double mass       = expected.impactor.mass,
                   plate_mass = geometry_of(impact.plate).area *
        expected.section.mass_per_area,
                   half_period =
                     half_space + std::acos(-1.) * std::sqrt(mass * compliance);
      // heavier than the plate it bends that as a whole, for half a period
      return {mass > plate_mass ? std::max(of_zener, 1.1 * half_period) :
                                  of_zener,
              2. * half_period,
              true};
    }



    /// A little after the end of the impact, on the mesh by longer steps, or as
    /// long as anybody waits. [s]
    /// @param factor  by which they are longer; less where that fails
    double
    end_by_steps(const LoadedPlate &plate,
                 const Parameters  &impact,
                 const ContactTime &wait,
                 const double       factor = 4.)
    {
      const double dt = impact.time.time_step;
      // few digits are needed, but every step counts
      TimeParameters coarse = impact.time;
      coarse.time_step *= factor;
      coarse.end_time = dt *
        std::ceil(std::min(most_steps_of_contact,
                           std::max(impact.time.end_time, wait.longest) / dt));
      TimeStepper stepper     = plate.steps(coarse);
      bool        is_touching = false;
      try
        {
          for (unsigned int step = 0; step < stepper.scheme.n_steps; ++step)
            {
              stepper.advance();
              const ContactState &state = stepper.state();
              if (is_touching && state.force == 0. &&
                  (!wait.is_held || state.impactor_velocity <= 0.))
                return dt * std::ceil(1.01 * state.time / dt);
              is_touching = is_touching || state.force > 0.;
            }
        }
      catch (const ComputationError &)
        {
          if (factor == 1.)
            throw;
          return end_by_steps(plate, impact, wait, 0.5 * factor);
        }
      return coarse.end_time;
    }
  } // namespace



  PlateModel::PlateModel(const PlateParameters          &plate,
                         const DiscretizationParameters &discretization,
                         std::unique_ptr<dealii::Triangulation<2>> part)
    : element(discretization.element,
              PlateSection(plate).stretching,
              discretization.mass)
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
        // makes room for another load: of Ritz vectors 0.8 GB are kept
        const unsigned int n_vectors = work().ritz_vectors;
        if (1. * (n_vectors - n_forgotten_vectors) * plate.n_unknowns() > 1e8)
          {
            n_forgotten_vectors = n_vectors;
            reductions.clear();
            loaded_meshes.clear();
          }
        reductions[key] =
          std::make_shared<RitzReduction>(loaded_mesh(impact),
                                          time,
                                          impact.contact.integration,
                                          needs_states);
        ++matrices->work.loads;
      }
    return {impact, reductions[key]};
  }



  const std::shared_ptr<LoadedMesh> &
  PlateModel::loaded_mesh(const Parameters &impact)
  {
    const MeshKey key = mesh_key(impact);
    if (const auto known = loaded_meshes.find(key);
        known != loaded_meshes.end())
      return known->second;
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
    // beta of the functional w + beta div theta, 0 for w alone: a half-space,
    // or the layer's own patch radius [m^2]
    double rotation_factor = 0.;
    if (contact.local_response == LocalResponse::layer)
      {
        const double h = impact.plate.thickness;
        const double beta =
          LayerResponse(plate.section, contact.load_distribution)
            .rotation_factor(contact.patch_radius / h);
        if (std::abs(beta) > 1e-9)
          rotation_factor = beta * h * h;
      }
    auto loaded = std::make_shared<LoadedMesh>(
      LoadedMesh{{matrices, plate.load(points, rotation_factor)}, {}});
    matrices->work.assembly_seconds += timer.wall_time();
    return loaded_meshes[key] = std::move(loaded);
  }



  std::vector<double>
  PlateModel::natural_frequencies(const unsigned int n)
  {
    return n > 0 ? PlateImpact::natural_frequencies(*assembled(), n) :
                   std::vector<double>();
  }



  const std::shared_ptr<EffectiveStiffness> &
  PlateModel::assembled()
  {
    if (matrices == nullptr)
      {
        const dealii::Timer timer;
        plate.assemble();
        // kept once it is whole: an impact that fails is not the last of a
        // sweep
        auto whole = std::make_shared<EffectiveStiffness>(plate, linear_solver);
        if (loss_factor > 0.)
          {
            const std::vector<double> frequencies =
              PlateImpact::natural_frequencies(*whole, 1);
            if (frequencies.empty())
              throw ComputationError(
                "the mesh has too few unknowns for the first natural "
                "frequency, to which Plate/Loss factor refers; choose more "
                "Discretization/Initial cells");
            // of the plate without damping [rad/s]
            const double first = 2. * std::acos(-1.) * frequencies.front();
            whole->damping     = loss_factor / first;
          }
        matrices = std::move(whole);
        // without what the search for the frequency took to factorize
        matrices->work.assembly_seconds =
          timer.wall_time() - matrices->work.factorization_seconds;
      }
    return matrices;
  }



  Parameters
  until_contact_ends(PlateModel       &plate,
                     const Parameters &impact,
                     const bool        needs_states,
                     const double      expected)
  {
    if (impact.time.end_time > 0.)
      return impact;
    Parameters result          = impact;
    result.time.end_is_chosen  = true;
    const double      dt       = impact.time.time_step;
    const ContactTime wait     = contact_time(impact,
                                          make_zener_impact(impact),
                                          plate.static_compliance(impact));
    const double      shortest = std::max(wait.shortest, expected) / dt;
    // by powers of two, so that impactors share responses
    for (double n = std::exp2(std::ceil(std::log2(shortest)));; n *= 2.)
      {
        result.time.end_of_vectors = result.time.end_time = n * dt;
        const LoadedPlate loaded = plate.under(result, needs_states);
        if (loaded.is_stepped_on_the_mesh())
          {
            // more steps take more vectors
            result.time.integrator = IntegratorType::Newmark;
            result.time.end_time   = end_by_steps(loaded, result, wait);
            return result;
          }
        const std::optional<double> end =
          loaded.strike().history.end_of_impact(wait.is_held);
        if (end)
          result.time.end_time = dt * std::ceil(*end / dt);
        if (end || n >= most_steps_of_contact || n * dt >= wait.longest)
          return result;
      }
  }
} // namespace PlateImpact
