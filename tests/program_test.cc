// What the executable computes: limits, steps, verdicts and warnings.
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

namespace PlateImpact
{
  namespace
  {
    TEST_F(Program, WrongNumbersAreNotTakenForRightOnes)
    {
      // a force twelve times too large on cells that see no wave
      ASSERT_EQ(run(SCENES "/extremes/foil.prm"), 0);
      EXPECT_EQ(summary()["verdict"]["trust"], "none");
      EXPECT_FALSE(last_cycle().contains("peak_force_error_bar"));
      EXPECT_NE(out.find("error not known"), std::string::npos) << out;
      EXPECT_EQ(study_of(
                  "report.html")["summary"]["verdict"]["convergence"]["trust"],
                "none");
      // missed targets and single meshes are no success
      ASSERT_EQ(run(main_scene, "--set 'Adaptivity/Maximum cycles=1'"), 0);
      EXPECT_EQ(summary()["verdict"]["trust"], "none");
      ASSERT_EQ(run(main_scene, "--set 'Adaptivity/Maximum cycles=2'"), 0);
      EXPECT_EQ(summary()["verdict"]["trust"], "doubtful");
      EXPECT_NE(summary()["verdict"]["text"].get<std::string>().find(
                  "target missed (maximum cycles)"),
                std::string::npos);
      ASSERT_EQ(run(main_scene, "--set Adaptivity/Strategy=none"), 0);
      EXPECT_NE(summary()["verdict"]["trust"], "good");
      // no limit
      ASSERT_EQ(run(SCENES "/paper-sphere.prm"), 0);
      EXPECT_EQ(summary()["verdict"]["trust"], "doubtful");
    }



    TEST_F(Program, ScenePaysOnlyForWhatItNeeds)
    {
      ASSERT_EQ(run(main_scene,
                    "--set Adaptivity/Strategy=none --set 'Output/Write "
                    "report=false' --set 'Time/Time step=1e-6'"),
                0);
      EXPECT_EQ(summary()["outcome"], "single mesh");
      EXPECT_FALSE(last_cycle().contains("discretization_error"));
      EXPECT_EQ(last_cycle()["work"]["estimator_samples"], 0);
      EXPECT_EQ(last_cycle()["work"]["factorizations"], 1);
      EXPECT_EQ(last_cycle()["work"]["linear_solves"],
                last_cycle()["work"]["ritz_vectors"]);
      EXPECT_LE(last_cycle()["work"]["linear_solves"], 40);

      ASSERT_EQ(run(main_scene, "--set Impactor/Shape=none"), 0) << err;
      EXPECT_EQ(summary()["outcome"], "single mesh");
      EXPECT_FALSE(last_cycle().contains("peak_force"));
      EXPECT_FALSE(last_cycle().contains("work"));
    }



    TEST_F(Program, UniformStrategyAndRectangularPlateWithTwoSupports)
    {
      ASSERT_EQ(
        run(main_scene,
            "--set Adaptivity/Strategy=uniform --set "
            "'Adaptivity/Maximum cycles=3' --set 'Plate/Side "
            "lengths=0.3,0.2' --set 'Plate/Support=clamped, free' --set "
            "'Discretization/Initial cells=6,4' --set 'Time/Time "
            "step=1e-6'"),
        0)
        << err;
      EXPECT_EQ(last_cycle()["cells"], 6 * 4 * 16);
      // No reflection is back at the peak: any plate of 8 mm steel will do.
      expect_near(last_cycle()["peak_force"], elastic_peak, 2e-3);
    }



    TEST_F(Program, EndsBeforeAMeshThatIsTooLarge)
    {
      for (const std::string strategy :
           {"hanging nodes", "remeshing", "uniform", "fixed number"})
        {
          ASSERT_EQ(run(main_scene,
                        "--set 'Adaptivity/Strategy=" + strategy +
                          "' --set 'Adaptivity/Target error=1e-300' --set "
                          "'Adaptivity/Maximum cells=30'"),
                    0)
            << err;
          EXPECT_EQ(summary()["outcome"], "maximum cells") << strategy;
          EXPECT_NE(err.find("not met"), std::string::npos) << err;
        }
    }



    TEST_F(Program, NoMeshHasMoreCellsThanAllowed)
    {
      for (const int limit : {60, 122, 150, 170})
        {
          ASSERT_EQ(run(main_scene,
                        half_space + "--set 'Adaptivity/Maximum cells=" +
                          std::to_string(limit) + "'"),
                    0)
            << err;
          EXPECT_EQ(summary()["outcome"], "maximum cells") << limit;
          const auto cycles = summary()["cycles"];
          for (const auto &cycle : cycles)
            EXPECT_LE(cycle["cells"], limit);
        }
    }



    TEST_F(Program, SamplesOfTheEstimatorAreEnough)
    {
      const auto eta = [this](const std::string &interval) {
        EXPECT_EQ(run(main_scene,
                      "--set 'Discretization/Initial cells=10,10' --set "
                      "Adaptivity/Strategy=none --set "
                      "'Adaptivity/Sampling interval=" +
                        interval + "'"),
                  0)
          << err;
        return last_cycle()["discretization_error"].get<double>();
      };
      const double every_step = eta("1");
      EXPECT_NEAR(eta("5") / every_step, 1., 0.01);
    }



    TEST_F(Program, ChoosesTheTimeStep)
    {
      ASSERT_EQ(run(main_scene,
                    "--set 'Time/Time step=0' --set "
                    "Adaptivity/Strategy=none"),
                0)
        << err;
      const auto chosen = last_cycle();
      EXPECT_LT(chosen["steps"], 400);
      ASSERT_EQ(run(main_scene,
                    "--set 'Time/Time step=1e-8' --set "
                    "Adaptivity/Strategy=none"),
                0)
        << err;
      // the error is what it was asked to be, and is told honestly
      const double error = std::abs(chosen["peak_force"].get<double>() /
                                      last_cycle()["peak_force"].get<double>() -
                                    1.);
      EXPECT_LT(error, 2e-4);
      EXPECT_LT(error, 3. * chosen["time_error"].get<double>());
      EXPECT_LT(last_cycle()["time_error"].get<double>(), 1e-6);
    }



    TEST_F(Program, WarnsWhereResultsLeaveTheModel)
    {
      ASSERT_EQ(
        run(main_scene,
            half_space +
              "--set Plate/Thickness=1e-4 --set Impactor/Velocity=50 --set "
              "Discretization/Element=serendipity --set "
              "Adaptivity/Strategy=none --set 'Output/Write report=false' "
              "--set 'Time/End time=10e-6' --set Time/Integrator=Newmark"),
        0)
        << err;
      for (const std::string part : {"of its thickness",
                                     "locks",
                                     "leaves an error of about",
                                     "do not resolve",
                                     "still moves"})
        EXPECT_NE(err.find(part), std::string::npos) << part << '\n' << err;
      EXPECT_EQ(summary()["warnings"].size(), 5u) << err;
      ASSERT_EQ(run(main_scene,
                    "--set Impactor/Velocity=30 --set Adaptivity/Strategy=none "
                    "--set 'Output/Write report=false'"),
                0)
        << err;
      EXPECT_NE(err.find("contact pressure"), std::string::npos) << err;
    }



    TEST_F(Program, WarnsOfAWideDiscUnderAHeavyBall)
    {
      // whose force hardly knows of the contact, by Zener's equation
      const std::string heavy = half_space +
        "--set Impactor/Mass=50 --set Impactor/Velocity=0.2 --set "
        "Plate/Thickness=0.005 --set Adaptivity/Strategy=none --set "
        "'Output/Write report=false' --set 'Contact/Patch radius=";
      ASSERT_EQ(run(main_scene, heavy + "0.05'"), 0) << err;
      EXPECT_NE(err.find("smooths out the waves"), std::string::npos) << err;
      ASSERT_EQ(run(main_scene, heavy + "0.005'"), 0) << err;
      EXPECT_EQ(err.find("smooths out the waves"), std::string::npos) << err;
    }
  } // namespace
} // namespace PlateImpact
