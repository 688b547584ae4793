#include "plate_impact/transient/struck_plate.h"

#include "plate_impact/contact/contact_law.h"
#include "plate_impact/plate/load_distribution.h"
#include "plate_impact/transient/linear_solver.h"
#include "plate_impact/transient/newmark_scheme.h"
#include "plate_impact/transient/time_stepper.h"

#include <utility>

namespace PlateImpact
{
  namespace
  {
    Impact
    step_to_end(TimeStepper stepper)
    {
      Impact result;
      result.history = history_to_end(stepper);
      result.impulse = stepper.impulse();
      return result;
    }



    /// Numbers in the Ritz vectors of all loads that are kept: 0.8 GB.
    constexpr double most_numbers = 1e8;
  } // namespace



  StruckPlate::StruckPlate(const PlateParameters          &plate,
                           const DiscretizationParameters &discretization,
                           std::unique_ptr<dealii::Triangulation<2>> quadrant)
    : element(discretization.element)
    , mesh(std::move(quadrant))
    , linear_solver(discretization.linear_solver)
    , plate_on_mesh(*mesh, element, plate)
  {
    plate_on_mesh.assemble();
  }



  const PlateDiscretization &
  StruckPlate::model() const
  {
    return plate_on_mesh;
  }



  unsigned int
  StruckPlate::n_loads() const
  {
    return n_made;
  }



  StruckPlate::LoadKey
  StruckPlate::load_key(const Parameters &parameters)
  {
    ContactParameters contact = parameters.contact;
    contact.law               = ForceLaw::Sun; // whatever it is
    return {contact,
            parameters.impactor.shape,
            parameters.impactor.length,
            parameters.time,
            parameters.needs_estimator()};
  }



  StruckPlate::Load &
  StruckPlate::prepare(const Parameters &parameters)
  {
    const LoadKey key   = load_key(parameters);
    auto          known = loads.find(key);
    if (known == loads.end())
      {
        double numbers = 0.;
        for (const auto &[other, load] : loads)
          if (load.reduction)
            numbers += 1. * load.reduction->n_vectors() * load.u.size();
        if (numbers > most_numbers)
          loads.clear();
        known      = loads.try_emplace(key).first;
        Load &load = known->second;
        load.u     = plate_on_mesh.load(
          make_load_distribution(parameters.contact,
                                 parameters.impactor.length));
        load.integration =
          make_contact_integration(parameters.contact.integration);
        ++n_made;
      }
    Load &load = known->second;
    if (plate == nullptr)
      plate = std::make_unique<FullSystem>(plate_on_mesh,
                                           load.u,
                                           make_linear_solver(linear_solver));
    else
      plate->set_load(load.u);
    return load;
  }



  Impact
  StruckPlate::strike(const Parameters &parameters)
  {
    Load          &load    = prepare(parameters);
    ReducedSystem *reduced = nullptr;
    if (parameters.time.integrator == IntegratorType::Ritz_vectors)
      {
        if (!load.reduction)
          load.reduction.emplace(*plate,
                                 plate_on_mesh.section(),
                                 parameters.time,
                                 *load.integration,
                                 parameters.needs_estimator());
        reduced = load.reduction->settle(parameters);
      }
    SemidiscreteSystem &stepped =
      reduced != nullptr ? static_cast<SemidiscreteSystem &>(*reduced) : *plate;

    const auto          law      = make_contact_law(parameters);
    const Impactor      impactor = make_impactor(parameters.impactor);
    const NewmarkScheme scheme(parameters.time);
    if (!scheme.conserves_energy())
      return step_to_end(
        {parameters.time, stepped, *law, *load.integration, impactor});
    if (reduced != nullptr)
      return load.reduction->response(*reduced).impact(*law, impactor);
    if (!load.response_of_mesh)
      load.response_of_mesh.emplace(scheme, *plate, *load.integration);
    return load.response_of_mesh->impact(*law, impactor);
  }
} // namespace PlateImpact
