#include "plate_impact/base/exceptions.h"
#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/transient/full_system.h"
#include "plate_impact/transient/time_stepper.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <memory>

namespace PlateImpact
{
  namespace
  {
    /// A mass on a spring, or nothing that moves when the load is zero.
    class SpringPlate : public SemidiscreteSystem
    {
    public:
      SpringPlate(const double stiffness,
                  const double mass,
                  const double load,
                  const bool   has_known_compliance = true,
                  const double damping              = 0.)
        : SemidiscreteSystem(Eigen::VectorXd::Constant(1, load), damping)
        , k(stiffness)
        , m(mass)
        , has_known_compliance(has_known_compliance)
      {}

      void
      multiply_stiffness(const Eigen::VectorXd &x,
                         Eigen::VectorXd       &y) const override
      {
        y = k * x;
      }

      void
      multiply_mass(const Eigen::VectorXd &x, Eigen::VectorXd &y) const override
      {
        y = m * x;
      }

      void
      solve(const double           c,
            const Eigen::VectorXd &b,
            Eigen::VectorXd       &x) override
      {
        x = b / (k + c * m);
      }

      double
      static_compliance() override
      {
        return has_known_compliance ? load.squaredNorm() / k :
                                      std::numeric_limits<double>::infinity();
      }

    private:
      const double k, m;
      const bool   has_known_compliance;
    };



    TimeParameters
    time_parameters(const double end_time,
                    const double step,
                    const double beta  = 0.25,
                    const double gamma = 0.5)
    {
      TimeParameters time;
      time.end_time      = end_time;
      time.time_step     = step;
      time.newmark_beta  = beta;
      time.newmark_gamma = gamma;
      return time;
    }



    /// The history of an impact to its end.
    ContactHistory
    run(SemidiscreteSystem       &plate,
        const TimeParameters     &time,
        const Contact            &contact,
        const ContactIntegration &integration,
        const Impactor           &impactor)
    {
      TimeStepper stepper({time, integration}, plate, contact, impactor);
      stepper.advance(stepper.scheme.n_steps);
      return stepper.impact().history;
    }



    const Contact            contact(std::make_shared<HertzLaw>(1e10));
    const ContactIntegration conserving  = ForceIntegration::energy_conserving;
    const ContactIntegration collocation = ForceIntegration::collocation;
    const Impactor           ball{0.03, 0., 1.};

    // exact impact on a rigid target (Johnson, Contact Mechanics, sec. 11.4)
    const double exact_indentation = std::pow(1.25 * ball.mass / 1e10, 0.4);
    const double exact_duration    = 2.9432659 * exact_indentation;



    TEST(TimeStepper, RigidTargetIsTheExactHertzImpact)
    {
      SpringPlate rigid(1., 1., 0.);
      for (const ContactIntegration &integration : {conserving, collocation})
        {
          const ContactHistory history =
            run(rigid,
                time_parameters(1.5 * exact_duration, exact_duration / 2000.),
                contact,
                integration,
                ball);
          EXPECT_NEAR(history.peak().force / contact.force(exact_indentation),
                      1.,
                      1e-5);
          EXPECT_NEAR(history.peak().time / exact_duration, 0.5, 1e-3);
          EXPECT_NEAR(*history.end_of_impact() / exact_duration, 1., 1e-5);
          EXPECT_NEAR(history.states.back().impactor_velocity, -1., 1e-4);
          EXPECT_EQ(history.n_contacts(), 1);
        }
    }



    TEST(TimeStepper, EnergyConservingReboundIsAsFastAsTheImpactForEveryStep)
    {
      SpringPlate rigid(1., 1., 0.);
      for (const double ratio : {1e-3, 0.1, 0.5, 1., 5., 20.})
        {
          const double step = ratio * exact_duration;
          EXPECT_NEAR(run(rigid,
                          time_parameters(exact_duration + 3. * step, step),
                          contact,
                          conserving,
                          ball)
                        .states.back()
                        .impactor_velocity,
                      -1.,
                      1e-11)
            << ratio;
        }
    }



    TEST(TimeStepper, CollocationGainsEnergyOnCoarseSteps)
    {
      // what the paper's scheme does, and why it is not the default
      SpringPlate  rigid(1., 1., 0.);
      const double step = exact_duration;
      EXPECT_LT(
        run(rigid, time_parameters(4. * step, step), contact, collocation, ball)
          .states.back()
          .impactor_velocity,
        -1.2);
    }



    /// Plate whose period is about the contact time.
    SpringPlate
    compliant_plate()
    {
      const double omega = 5. / exact_duration;
      return SpringPlate(0.1 * omega * omega, 0.1, 1.);
    }



    double
    convergence_ratio(const ContactIntegration &integration,
                      const double              beta,
                      const double              gamma,
                      const unsigned int        n)
    {
      SpringPlate plate       = compliant_plate();
      const auto  velocity_at = [&](const unsigned int n_steps) {
        // before the contact ends: the solution is smooth
        return run(plate,
                   time_parameters(0.6 * exact_duration,
                                   0.6 * exact_duration / n_steps,
                                   beta,
                                   gamma),
                   contact,
                   integration,
                   ball)
          .states.back()
          .impactor_velocity;
      };
      const double coarse = velocity_at(n), medium = velocity_at(2 * n),
                   fine = velocity_at(4 * n);
      return (coarse - medium) / (medium - fine);
    }



    TEST(TimeStepper, AverageAccelerationIsOfSecondOrder)
    {
      EXPECT_NEAR(convergence_ratio(conserving, 0.25, 0.5, 400), 4., 0.1);
      EXPECT_NEAR(convergence_ratio(collocation, 0.25, 0.5, 400), 4., 0.1);
      EXPECT_NEAR(convergence_ratio(collocation, 1. / 3., 0.5, 400), 4., 0.1);
    }



    TEST(TimeStepper, DampedNewmarkIsOfFirstOrder)
    {
      EXPECT_NEAR(convergence_ratio(collocation, 0.3025, 0.6, 4000), 2., 0.1);
      EXPECT_NEAR(convergence_ratio(collocation, 0.5, 0.6, 4000), 2., 0.1);
    }



    /// Displacement of a damped mass on a spring under a force that grows by 1
    /// a second, by any of Newmark's schemes.
    double
    under_a_growing_force(const TimeParameters &time)
    {
      SpringPlate         plate(4.,
                        1.,
                        1.,
                        /*has_known_compliance=*/true,
                        /*damping=*/0.1);
      const NewmarkScheme scheme(time, conserving);
      const auto          motion = plate.motion(scheme);
      for (unsigned int n = 0; n < scheme.n_steps; ++n)
        {
          motion->begin_step(n * scheme.dt);
          motion->end_step(0., (n + 1) * scheme.dt);
        }
      return motion->w;
    }



    TEST(TimeStepper, DampedPlateFollowsTheExactMotion)
    {
      // m w'' + b k w' + k w = t from rest: omega = 2, a ratio of 0.1
      const double k = 4., omega = 2., ratio = 0.1, t = 3.,
                   damped = omega * std::sqrt(1. - ratio * ratio),
                   exact  = (t - 2. * ratio / omega +
                            std::exp(-ratio * omega * t) *
                              (2. * ratio / omega * std::cos(damped * t) +
                               (2. * ratio * ratio - 1.) / damped *
                                 std::sin(damped * t))) /
        k;
      for (const auto &[beta, gamma, order] :
           {std::make_tuple(0.25, 0.5, 2.),
            std::make_tuple(1. / 3., 0.5, 2.),
            std::make_tuple(0.3025, 0.6, 1.),
            std::make_tuple(0.3, 0.6, 1.)})
        {
          const auto error = [&, beta = beta, gamma = gamma](const double dt) {
            return std::abs(
              under_a_growing_force(time_parameters(t, dt, beta, gamma)) -
              exact);
          };
          EXPECT_LT(error(0.001), 1e-3) << beta << ' ' << gamma;
          EXPECT_NEAR(std::log2(error(0.002) / error(0.001)), order, 0.1)
            << beta << ' ' << gamma;
        }
    }



    TEST(TimeStepper, ImpulseIsTheChangeOfMomentumAndTheIntegralOfTheForce)
    {
      SpringPlate plate = compliant_plate();
      TimeStepper stepper({time_parameters(2. * exact_duration,
                                           exact_duration / 500.),
                           conserving},
                          plate,
                          contact,
                          ball);
      double      integral = 0., last_force = 0., last_time = 0.;
      for (unsigned int step = 0; step < stepper.scheme.n_steps; ++step)
        {
          stepper.advance();
          const ContactState &state = stepper.state();
          integral +=
            0.5 * (state.force + last_force) * (state.time - last_time);
          last_force = state.force;
          last_time  = state.time;
        }
      const double change =
        ball.mass * (ball.velocity - stepper.state().impactor_velocity);
      EXPECT_NEAR(stepper.impact().impulse / change, 1., 1e-12);
      EXPECT_NEAR(integral / change, 1., 1e-4);
    }



    /// A light plate strikes a heavy impactor several times.
    SpringPlate
    bouncing_plate(const bool has_known_compliance)
    {
      const double omega = 1. / exact_duration, mass = 0.2 * ball.mass;
      return SpringPlate(omega * omega * mass, mass, 1., has_known_compliance);
    }



    TEST(TimeStepper, SeparatesForGoodOnlyAfterTheLastContact)
    {
      const TimeParameters time =
        time_parameters(40. * exact_duration, exact_duration / 200.);
      for (const ContactIntegration &integration : {conserving, collocation})
        {
          SpringPlate known   = bouncing_plate(true),
                      unknown = bouncing_plate(false);
          TimeStepper with({time, integration}, known, contact, ball),
            without({time, integration}, unknown, contact, ball);
          with.advance(with.scheme.n_steps);
          without.advance(without.scheme.n_steps);
          const ContactHistory &history  = with.impact().history,
                               &complete = without.impact().history;
          const std::optional<double> separation_time =
            with.impact().separation_time;
          EXPECT_GE(complete.n_contacts(), 3u);
          EXPECT_LT(history.relative_energy_drift(),
                    integration.acts_at_begin ? 1e-11 : 1e-4);
          EXPECT_FALSE(without.impact().separation_time);
          ASSERT_TRUE(separation_time);
          bool had_gap = false;
          for (std::size_t n = 0; n < history.states.size(); ++n)
            {
              const ContactState &state = history.states[n];
              EXPECT_EQ(state.indentation, complete.states[n].indentation);
              if (state.time >= *separation_time)
                EXPECT_EQ(complete.states[n].force, 0.);
              else if (n > 0 && state.force == 0.)
                had_gap = true;
            }
          EXPECT_TRUE(had_gap);
          EXPECT_LT(*separation_time, time.end_time);
        }
    }



    // runs that only compute a force, as Verify does, have no listener
    TEST(TimeStepper, StopsAtTheNextStepAfterASignal)
    {
      SpringPlate    plate(1e6, 1., 0.);
      TimeParameters time = time_parameters(1e-3, 1e-6);
      TimeStepper    stepper({time, conserving}, plate, contact, ball);
      stepper.advance(3);
      await_interrupt();
      std::raise(SIGTERM);
      EXPECT_THROW(stepper.advance(stepper.scheme.n_steps - 3), Interruption);
      EXPECT_EQ(stepper.impact().history.states.size(), 4u);
      await_interrupt(); // forgets the signal
      stepper.advance(1);
      await_interrupt(/*ends_at_once=*/true);
    }



    TEST(TimeStepper, EndTimeIsReachedExactly)
    {
      SpringPlate plate = compliant_plate();
      TimeStepper stepper({time_parameters(1e-4, 3e-5), conserving},
                          plate,
                          contact,
                          ball);
      EXPECT_EQ(stepper.scheme.n_steps, 4);
      stepper.advance(4);
      EXPECT_DOUBLE_EQ(stepper.state().time, 1e-4);
      EXPECT_EQ(TimeStepper({time_parameters(80e-6, 1e-7), conserving},
                            plate,
                            contact,
                            ball)
                  .scheme.n_steps,
                800);
    }



    TEST(TimeStepper, PlateEnergyIsThatOfItsMatrices)
    {
      // The stepper follows K z and M v without products with K and M; here
      // they are formed. The velocity of average acceleration follows from z.
      const auto            mesh  = unit_square(4);
      const PlateParameters plate = unit_plate(EdgeSupport::clamped, 0.1);
      const PlateElement    element(ElementType::heterosis);
      PlateDiscretization   model(*mesh, element, plate, 1.);
      model.assemble();
      FullSystem meshed(
        std::make_shared<EffectiveStiffness>(model, SolverType::CHOLMOD),
        model.load({{dealii::Point<2>(0.5, 0.5), 1.}}));
      const Contact   soft(std::make_shared<HertzLaw>(1.));
      const double    dt = 0.05;
      TimeStepper     stepper({time_parameters(5., dt), conserving},
                          meshed,
                          soft,
                          {1., 0., 1.});
      Eigen::VectorXd z = stepper.displacement(), v = z;
      double          largest = 0.;
      for (unsigned int step = 0; step < stepper.scheme.n_steps; ++step)
        {
          stepper.advance();
          v                   = 2. / dt * (stepper.displacement() - z) - v;
          z                   = stepper.displacement();
          const double energy = 0.5 *
            (z.dot(multiply(model.stiffness(), z)) +
             v.dot(multiply(model.mass(), v)));
          largest = std::max(largest, energy);
          EXPECT_NEAR(stepper.state().plate_energy, energy, 1e-10);
        }
      EXPECT_GT(largest, 0.01);
    }



    TEST(TimeStepper, ValuesThatAreNotFiniteStopTheRunAndNameTheStep)
    {
      SpringPlate broken(std::numeric_limits<double>::infinity(), 1., 1.);
      TimeStepper stepper({time_parameters(1e-4, 1e-5), conserving},
                          broken,
                          contact,
                          ball);
      try
        {
          stepper.advance(10);
          FAIL();
        }
      catch (const ComputationError &error)
        {
          EXPECT_NE(std::string(error.what()).find("step 1"), std::string::npos)
            << error.what();
        }
    }
  } // namespace
} // namespace PlateImpact
