#include "plate_impact/struck_plate.h"

#include "plate_impact/contact_law.h"
#include "plate_impact/linear_solver.h"
#include "plate_impact/load_patch.h"
#include "plate_impact/newmark_scheme.h"
#include "plate_impact/time_stepper.h"

#include <tuple>
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



    /// What makes the load and the steps of an impact, in comparable form.
    auto
    preparation(const Parameters &parameters)
    {
      const ContactParameters &contact = parameters.contact;
      const TimeParameters    &time    = parameters.time;
      return std::make_tuple(contact.load_distribution,
                             contact.patch_radius,
                             contact.integration,
                             parameters.impactor.length,
                             parameters.needs_estimator(),
                             time.integrator,
                             time.end_time,
                             time.time_step,
                             time.ritz_tolerance,
                             time.newmark_beta,
                             time.newmark_gamma);
    }
  } // namespace



  StruckPlate::StruckPlate(const PlateParameters          &plate,
                           const DiscretizationParameters &discretization,
                           std::unique_ptr<dealii::Triangulation<2>> quadrant)
    : element(discretization.element)
    , mesh(std::move(quadrant))
    , linear_solver(discretization.linear_solver)
    , plate_model(*mesh, element, plate)
  {
    plate_model.assemble();
  }



  const PlateModel &
  StruckPlate::model() const
  {
    return plate_model;
  }



  unsigned int
  StruckPlate::n_loads() const
  {
    return loads;
  }



  void
  StruckPlate::prepare(const Parameters &parameters)
  {
    if (prepared && preparation(*prepared) == preparation(parameters))
      return;
    prepared.reset();
    responses.clear();
    reduction.reset();
    const Eigen::VectorXd load = plate_model.load(
      make_load_patch(parameters.contact, parameters.impactor.length));
    if (plate == nullptr)
      plate = std::make_unique<MeshPlate>(plate_model,
                                          load,
                                          make_linear_solver(linear_solver));
    else
      plate->set_load(load);
    integration = make_contact_integration(parameters.contact.integration);
    prepared    = parameters;
    ++loads;
  }



  Impact
  StruckPlate::strike(const Parameters &parameters)
  {
    prepare(parameters);
    RitzPlate *reduced = nullptr;
    if (parameters.time.integrator == "Ritz vectors")
      {
        if (!reduction)
          reduction.emplace(*plate,
                            plate_model.section(),
                            parameters.time,
                            parameters.needs_estimator());
        reduced = reduction->settle(parameters, *integration);
      }
    SemidiscretePlate &stepped =
      reduced != nullptr ? static_cast<SemidiscretePlate &>(*reduced) : *plate;

    const auto          law      = make_contact_law(parameters);
    const Impactor      impactor = make_impactor(parameters.impactor);
    const NewmarkScheme scheme(parameters.time);
    if (!scheme.conserves_energy())
      return step_to_end(
        {parameters.time, stepped, *law, *integration, impactor});
    return responses.try_emplace(&stepped, scheme, stepped, *integration)
      .first->second.impact(*law, impactor);
  }
} // namespace PlateImpact
