#include "plate_impact/transient/struck_plate.h"

#include "plate_impact/base/stage_clock.h"
#include "plate_impact/contact/make_contact.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/transient/linear_solver.h"
#include "plate_impact/transient/make_integrator.h"
#include "plate_impact/transient/natural_frequencies.h"

#include <algorithm>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    /// Numbers in the Ritz vectors of all loads that are kept: 0.8 GB.
    constexpr double most_kept_numbers = 1e8;



    unsigned int
    n_vectors(const Load &load)
    {
      return load.integrator->n_vectors() + load.n_vectors_for_errors;
    }
  } // namespace



  StruckPlate::StruckPlate(const PlateParameters          &plate,
                           const DiscretizationParameters &discretization,
                           std::unique_ptr<dealii::Triangulation<2>> part)
    : element(discretization.element)
    , mesh(std::move(part))
    , linear_solver(discretization.linear_solver)
    , plate(*mesh, element, plate)
  {}



  LoadedPlate
  StruckPlate::under(const Parameters &impact, const bool needs_states)
  {
    const LoadKey key   = load_key(impact, needs_states);
    auto          known = loads.find(key);
    if (known == loads.end())
      {
        forget_loads();
        known = loads.emplace(key, make_load(impact, needs_states)).first;
      }
    return {impact, known->second};
  }



  std::shared_ptr<Load>
  StruckPlate::make_load(const Parameters &impact, const bool needs_states)
  {
    assembled();
    StageClock            clock;
    std::shared_ptr<Load> load(new Load{
      FullSystem(
        matrices,
        plate.load(on_meshed_part(make_load_distribution(impact.contact,
                                                         impact.impactor.length,
                                                         finest_cell_under_load(
                                                           impact)),
                                  impact.plate),
                   load_rotation_factor(impact.plate, impact.contact))),
      layer_constant(impact.plate, impact.contact),
      make_contact_integration(impact.contact.integration),
      nullptr});
    TimeParameters        to_horizon = impact.time;
    to_horizon.end_time = std::max(impact.time.end_time, impact.time.horizon);
    load->integrator    = make_integrator(to_horizon,
                                       impact.plate,
                                       load->system,
                                       *load->integration,
                                       needs_states);
    ++n_loads;
    clock.charge(assembly_seconds);
    return load;
  }



  std::vector<double>
  StruckPlate::natural_frequencies(const unsigned int n)
  {
    if (n == 0)
      return {};
    FullSystem without_load(assembled(), Eigen::VectorXd());
    return PlateImpact::natural_frequencies(plate, without_load, n);
  }



  const std::shared_ptr<EffectiveStiffness> &
  StruckPlate::assembled()
  {
    if (matrices == nullptr)
      {
        StageClock clock;
        plate.assemble();
        matrices = std::make_shared<EffectiveStiffness>(plate,
                                                        make_linear_solver(
                                                          linear_solver));
        clock.charge(assembly_seconds);
      }
    return matrices;
  }



  double
  StruckPlate::finest_cell_under_load(const Parameters &impact) const
  {
    const ContactParameters &contact = impact.contact;
    return cell_sizes_near_load(*mesh,
                                impact.impactor.contact_half_length(),
                                contact.has_patch() ? contact.patch_radius : 0.)
      .first;
  }



  void
  StruckPlate::forget_loads()
  {
    double numbers = 0.;
    for (const auto &[key, load] : loads)
      numbers +=
        1. * load->integrator->n_vectors() * load->system.load().size();
    if (numbers <= most_kept_numbers)
      return;
    for (const auto &[key, load] : loads)
      n_forgotten_vectors += n_vectors(*load);
    loads.clear();
  }



  StruckPlate::LoadKey
  StruckPlate::load_key(const Parameters &impact, const bool needs_states)
  {
    ContactParameters contact    = impact.contact;
    contact.law                  = {}; // whatever it is
    contact.unloading            = {};
    contact.critical_indentation = 0.;
    TimeParameters time          = impact.time;
    time.end_time                = std::max(time.end_time, time.horizon);
    return {contact,
            impact.impactor.shape,
            impact.impactor.length,
            time,
            needs_states};
  }



  const PlateDiscretization &
  StruckPlate::discretization() const
  {
    return plate;
  }



  StruckPlate::Work
  StruckPlate::work() const
  {
    Work work;
    work.loads            = n_loads;
    work.ritz_vectors     = n_forgotten_vectors;
    work.assembly_seconds = assembly_seconds;
    for (const auto &[key, load] : loads)
      work.ritz_vectors += n_vectors(*load);
    if (matrices != nullptr)
      {
        work.factorizations        = matrices->n_factorizations();
        work.linear_solves         = matrices->n_solves();
        work.factorization_seconds = matrices->factorization_seconds();
      }
    return work;
  }
} // namespace PlateImpact
