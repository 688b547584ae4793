#include "plate_impact/transient/plate_response.h"

#include "plate_impact/base/exceptions.h"

namespace PlateImpact
{
  namespace
  {
    /// The motion of a plate under the load by its response. Unknowns it has
    /// none.
    class ConvolvedMotion : public PlateMotion
    {
    public:
      /// @param reversed  must outlive the motion
      ConvolvedMotion(const NewmarkScheme   &scheme,
                      const Eigen::VectorXd &reversed)
        : reversed(reversed)
        , forces(reversed.size())
      {
        // the response has phi at the beginning of the step as well
        w_of_unit_response = reversed[reversed.size() - 1] /
          (scheme.integration.acts_at_begin ? 1. + scheme.c2 : 1.);
      }

      double
      begin_step(const double begin_force) override
      {
        known_force = begin_force;
        free        = forces.head(n_forces).dot(
          reversed.segment(reversed.size() - 1 - step, n_forces));
        return free;
      }

      std::optional<double>
      end_step(const double at_begin, const double at_end) override
      {
        forces[step++] = at_end;
        if (at_end != 0.)
          n_forces = step;
        const double w_end = free + reversed[reversed.size() - 1] * at_end;
        work += 0.5 * (known_force + at_begin + at_end) * (w_end - w);
        w = w_end;
        return {};
      }

      double
      energy() const override
      {
        return work;
      }

    private:
      const Eigen::VectorXd &reversed;
      Eigen::VectorXd        forces;       ///< phi of the steps so far
      Eigen::Index           n_forces = 0; ///< up to the last that is not zero
      Eigen::Index           step     = 0;
      double                 known_force = 0., free = 0., work = 0.;
    };
  } // namespace



  PlateResponse::PlateResponse(const NewmarkScheme &scheme,
                               SemidiscreteSystem  &plate)
    : scheme(scheme)
    , reversed(scheme.n_steps)
  {
    step_under(Eigen::VectorXd::Unit(scheme.n_steps, 0),
               scheme,
               plate,
               [this](const Eigen::Index step, const PlateStepper &stepper) {
                 reversed[reversed.size() - step] = stepper.displacement();
               });
    if (!reversed.allFinite())
      throw ComputationError(
        "the response of the plate to a unit force is not finite; try a "
        "smaller Time/Time step");
  }



  Impact
  PlateResponse::impact(const Contact     &contact,
                        const Impactor    &impactor,
                        const unsigned int n_steps) const
  {
    TimeStepper stepper(scheme,
                        std::make_unique<ConvolvedMotion>(scheme, reversed),
                        contact,
                        impactor);
    stepper.advance(n_steps);
    return stepper.impact();
  }
} // namespace PlateImpact
