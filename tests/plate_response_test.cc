#include "plate_impact/contact/hertz_law.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  namespace
  {
    /// Largest difference of a quantity over time, relative to its largest
    /// value.
    double
    difference(const ContactHistory &a,
               const ContactHistory &b,
               double ContactState::*quantity)
    {
      EXPECT_EQ(a.states.size(), b.states.size());
      double largest = 0., value = 0.;
      for (std::size_t n = 0; n < b.states.size(); ++n)
        {
          const double expected = b.states[n].*quantity;
          largest =
            std::max(largest, std::abs(a.states[n].*quantity - expected));
          value = std::max(value, std::abs(expected));
        }
      EXPECT_GT(value, 0.);
      return largest / value;
    }



    void
    expect_same_histories(const ForceIntegration integration)
    {
      const auto          mesh = unit_square(4);
      const PlateElement  element(ElementType::MITC9);
      PlateDiscretization model(*mesh,
                                element,
                                unit_plate(EdgeSupport::clamped, 0.1),
                                1.);
      model.assemble();
      FullSystem plate(
        std::make_shared<EffectiveStiffness>(model, SolverType::CHOLMOD),
        model.load({{dealii::Point<2>(0.5, 0.5), 1.}}));
      TimeParameters time;
      time.end_time      = 20.;
      time.time_step     = 0.02;
      time.newmark_beta  = 0.25;
      time.newmark_gamma = 0.5;

      const NewmarkScheme scheme(time, integration);
      const PlateResponse response(scheme, plate);
      unsigned int        most_contacts = 0;
      for (const double mass : {0.01, 0.1, 1., 100.})
        for (const double stiffness : {0.1, 10.})
          {
            const Contact  contact(std::make_shared<HertzLaw>(stiffness));
            const Impactor impactor{mass, 0., 0.5};
            TimeStepper    stepper(scheme, plate, contact, impactor);
            stepper.advance(stepper.scheme.n_steps);
            const ContactHistory &expected = stepper.impact().history;
            TimeStepper           by_response(scheme,
                                    plate,
                                    contact,
                                    impactor,
                                    std::make_unique<PlateResponse>(response));
            by_response.advance(scheme.n_steps);
            const Impact impact = by_response.impact();
            for (const auto quantity : {&ContactState::time,
                                        &ContactState::force,
                                        &ContactState::plate_displacement,
                                        &ContactState::impactor_velocity,
                                        &ContactState::plate_energy,
                                        &ContactState::contact_energy})
              EXPECT_LT(difference(impact.history, expected, quantity), 1e-10);
            EXPECT_NEAR(impact.impulse / stepper.impact().impulse, 1., 1e-10);
            most_contacts = std::max(most_contacts, expected.n_contacts());
          }
      EXPECT_GT(most_contacts, 2u);
    }



    TEST(PlateResponse, GivesTheHistoriesOfTheTimeStepper)
    {
      expect_same_histories(ForceIntegration::energy_conserving);
    }

    TEST(PlateResponse, GivesThoseOfCollocatedContact)
    {
      expect_same_histories(ForceIntegration::collocation);
    }
  } // namespace
} // namespace PlateImpact
