// Whole runs by Ritz vectors and by steps on the mesh: that both give the same,
// what each costs, and what they say of their steps.
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  namespace
  {
    class Integrators : public Program
    {};

    TEST_F(Integrators, IntegratorsReportTheSame)
    {
      const std::string common = half_space +
        "--set Adaptivity/Strategy=none --set 'Discretization/Initial "
        "cells=5,5' --set 'Time/End time=600e-6' --set 'Time/Time step=2e-6' "
        "--set Plate/Thickness=";
      // several contacts, and one after which the ball is gone
      for (const auto &[thickness, reported] :
           {std::make_pair("0.003", "sensitivity"),
            std::make_pair("0.004", "no_contact_after")})
        {
          nlohmann::json cycles[2];
          for (const bool is_reduced : {false, true})
            {
              ASSERT_EQ(run(main_scene,
                            common + thickness + " --set 'Time/Integrator=" +
                              (is_reduced ? "Ritz vectors'" : "Newmark'")),
                        0)
                << err;
              cycles[is_reduced] = last_cycle();
            }
          EXPECT_TRUE(cycles[0].contains(reported)) << thickness;
          for (const auto &[key, value] : cycles[0].items())
            EXPECT_TRUE(cycles[1].contains(key)) << key;
          for (const auto &[key, value] : cycles[1].items())
            EXPECT_TRUE(cycles[0].contains(key)) << key;
          expect_near(cycles[0][reported], cycles[1][reported], 1e-2);
        }
    }



    // Vectors are judged in longer steps where there are very many, which must
    // not be too long for a contact.
    TEST_F(Integrators, RitzVectorsGiveTheHistoryOfTheMeshInManySteps)
    {
      const std::string many =
        "--set Adaptivity/Strategy=none --set 'Discretization/Initial "
        "cells=5,5' --set 'Time/End time=3e-3' --set 'Time/Time step=2e-7' ";
      nlohmann::json cycles[2];
      for (const bool is_reduced : {false, true})
        {
          ASSERT_EQ(run(main_scene,
                        many + "--set 'Time/Integrator=" +
                          (is_reduced ? "Ritz vectors'" : "Newmark'")),
                    0)
            << err;
          cycles[is_reduced] = last_cycle();
        }
      EXPECT_GT(cycles[1]["work"]["ritz_vectors"], 0);
      for (const char *quantity : {"peak_force",
                                   "first_contact_end",
                                   "final_impactor_velocity",
                                   "impulse"})
        expect_near(cycles[1][quantity], cycles[0][quantity], 1e-4);
    }



    TEST_F(Integrators, RitzVectorsGiveTheHistoryOfTheMesh)
    {
      const std::string conserving =
        "--set Adaptivity/Strategy=none --set 'Discretization/Initial "
        "cells=8,8' --set 'Contact/Integration=energy conserving' ";
      for (const std::string &scene :
           {main_scene, std::string(SCENES "/paper-cylinder.prm")})
        {
          ASSERT_EQ(run(scene, conserving + "--set Time/Integrator=Newmark"), 0)
            << err;
          const auto mesh = last_cycle();
          ASSERT_EQ(run(scene,
                        conserving + "--set 'Time/Integrator=Ritz vectors'"),
                    0)
            << err;
          const auto ritz = last_cycle();
          // a force that was stepped on the mesh has no error of vectors
          for (const auto &[result, of_vectors] :
               {std::make_pair(mesh, 0.), std::make_pair(ritz, 1e-5)})
            if (result.contains("peak_force_error_bar"))
              {
                EXPECT_NEAR(result["peak_force_error_bar"].get<double>() -
                              result["peak_force_error_space"].get<double>() -
                              result["peak_force_error_time"].get<double>(),
                            of_vectors,
                            1e-12);
              }
          expect_near(ritz["peak_force"], mesh["peak_force"], 2e-5);
          expect_near(ritz["first_contact_end"],
                      mesh["first_contact_end"],
                      1e-4);
          expect_near(ritz["discretization_error"],
                      mesh["discretization_error"],
                      1e-3);
          EXPECT_LT(ritz["relative_energy_drift"], 1e-10);
          EXPECT_EQ(ritz["work"]["linear_solves"],
                    ritz["work"]["ritz_vectors"]);
          EXPECT_LT(ritz["work"]["ritz_vectors"], 200);
          EXPECT_FALSE(mesh.contains("no_contact_after"));
        }
    }



    TEST_F(Integrators, DampedPlateKeepsTheBalanceAndDecaysAsItsLossFactorSays)
    {
      const double      loss_factor = 0.02;
      const std::string damped =
        "--set 'Plate/Loss factor=0.02' --set Adaptivity/Strategy=none --set "
        "'Discretization/Initial cells=6,6' --set 'Output/Natural "
        "frequencies=1' --set 'Time/End time=12e-3' --set 'Time/Time "
        "step=2e-6' ";
      ASSERT_EQ(run(main_scene, damped), 0) << err;
      const auto ritz    = last_cycle();
      const auto history = rows("contact_history.csv");
      EXPECT_LT(ritz["relative_energy_drift"], 1e-9);
      EXPECT_GT(ritz["plate_dissipated_energy"], 1e-3);
      // long after the contact the first mode is left, whose energy decays by
      // the loss factor times omega
      const double omega =
        2. * M_PI * ritz["natural_frequencies"][0].get<double>();
      const auto energy_at = [&](const double time) {
        return std::stod(
          std::find_if(history.begin(), history.end(), [&](const Row &row) {
            return std::stod(row.at("time")) >= time;
          })->at("plate_energy"));
      };
      const double half_periods = 18. * M_PI / omega; // 5 ms
      expect_near(std::log(energy_at(6e-3) / energy_at(6e-3 + half_periods)) /
                    half_periods,
                  loss_factor * omega,
                  2e-3);
      ASSERT_EQ(run(main_scene, damped + "--set Time/Integrator=Newmark"), 0)
        << err;
      for (const auto *quantity : {"peak_force", "plate_dissipated_energy"})
        expect_near(last_cycle()[quantity], ritz[quantity], 2e-5);
      // a sweep takes the same steps
      ASSERT_EQ(sweep(main_scene,
                      damped +
                        "--set 'Sweep/Entry 1=Impactor/Velocity' --set "
                        "'Sweep/Values 1=1, 2'"),
                0)
        << err;
      for (const auto *quantity : {"peak_force", "plate_dissipated_energy"})
        expect_near(std::stod(rows()[0].at(quantity)), ritz[quantity], 1e-9);
    }



    TEST_F(Integrators, DampingThatIsTooMuchForTheContactIsTold)
    {
      ASSERT_EQ(run(main_scene,
                    "--set 'Plate/Loss factor=0.2' --set "
                    "Adaptivity/Strategy=none"),
                0);
      EXPECT_NE(err.find("Plate/Loss factor = 0.2 holds at the first natural"),
                std::string::npos)
        << err;
      // a thin plate whose force rises in a tenth of its contact
      ASSERT_EQ(
        run(main_scene,
            "--set 'Plate/Side lengths=0.4, 0.25' --set "
            "Plate/Thickness=0.005 --set 'Plate/Loss factor=0.05' --set "
            "'Time/End time=0' --set Impactor/Radius=0.015"),
        0);
      EXPECT_NE(err.find("Plate/Loss factor = 0.05 holds at the first natural"),
                std::string::npos)
        << err;
      EXPECT_EQ(run(main_scene, "--set 'Plate/Loss factor=-1'"), 1);
      EXPECT_NE(err.find("Plate/Loss factor"), std::string::npos) << err;
    }



    TEST_F(Integrators, ContactWorkEndsWhenNothingCanBringTheBodiesTogether)
    {
      const std::string setting =
        "--set 'Time/End time=300e-6' --set Adaptivity/Strategy=none --set "
        "'Output/Write report=false' --set 'Discretization/Initial cells=6,6' ";
      ASSERT_EQ(run(main_scene, setting), 0) << err;
      const double end = last_cycle()["no_contact_after"];
      EXPECT_GT(end, last_cycle()["first_contact_end"].get<double>());
      EXPECT_LT(end, 290e-6);
      // a plate that is free to move may follow the impactor
      ASSERT_EQ(run(main_scene, setting + "--set Plate/Support=free"), 0)
        << err;
      EXPECT_FALSE(last_cycle().contains("no_contact_after"));
    }



    TEST_F(Integrators, SteppingOnTheMeshWhereRitzVectorsCostMore)
    {
      ASSERT_EQ(run(main_scene,
                    "--set 'Time/Time step=2e-6' "
                    "--set 'Time/Ritz tolerance=1e-9' "
                    "--set 'Adaptivity/Maximum cycles=2'"),
                0)
        << err;
      EXPECT_GT(last_cycle()["work"]["ritz_vectors"], 16);
      EXPECT_LE(last_cycle()["work"]["ritz_vectors"], 55);
      // 40 steps and 10 of the double length up to the peak; fewer vectors
      // serve for the estimate of its error
      EXPECT_EQ(last_cycle()["work"]["linear_solves"].get<int>(),
                40 + 10 + last_cycle()["work"]["ritz_vectors"].get<int>());
      EXPECT_EQ(last_cycle()["work"]["factorizations"].get<int>(), 4);
      EXPECT_LT(last_cycle()["time_error"].get<double>(), 2e-3);
      expect_near(last_cycle()["peak_force"], elastic_peak, 2e-3);
    }



    /// A heavy ball on a plate of 0.2 mm: its basis is exhausted before all
    /// unknowns are used.
    const std::string thin_plate_and_heavy_ball =
      " --set Plate/Thickness=2e-4 --set Impactor/Mass=0.312 --set "
      "Impactor/Velocity=4.7568e-4 --set 'Contact/Patch radius=1e-3' --set "
      "Contact/Law=Sun --set 'Time/End time=0.08163' --set 'Time/Time "
      "step=2.0407e-5' --set Adaptivity/Strategy=uniform ";



    /// A thin roller on a large plate: energies grew without bound where
    /// round-off had made the mass of the vectors indefinite.
    const std::string roller_on_a_thin_plate =
      " --set 'Plate/Side lengths=2.88572, 2.88572' --set "
      "Plate/Thickness=0.00389152 --set \"Plate/Young's modulus=1.43066e10\" "
      "--set \"Plate/Poisson's ratio=0.212476\" --set Plate/Density=3164.79 "
      "--set 'Plate/Support=clamped, simply supported' --set "
      "Impactor/Shape=cylinder --set Impactor/Radius=0.000665347 --set "
      "Impactor/Length=2.88572 --set \"Impactor/Young's modulus=1.1e11\" --set "
      "Impactor/Density=4500 --set Impactor/Velocity=2.43839 --set "
      "Contact/Law=line --set 'Contact/Load distribution=strip' --set "
      "'Contact/Patch radius=0.00508789' --set 'Time/End time=0.000141208' "
      "--set 'Time/Time step=0' --set 'Discretization/Initial cells=1, 4' --set "
      "Adaptivity/Strategy=uniform --set 'Adaptivity/Maximum cycles=2' --set "
      "'Output/Field samples=1' ";



    TEST_F(Integrators, KernelsOfBlasDoNotMatterOnceTheSpaceIsExhausted)
    {
      const std::string
        lesson = SCENES "/course/05-locking.prm",
        exercise =
          " --set Discretization/Element=MITC9 --set Plate/Thickness=2e-5 --set "
          "Impactor/Velocity=6e-7 --set \"Impactor/Young's modulus=2e6\" --set "
          "'Time/End time=5' --set 'Time/Time step=0.01'";
      struct Case
      {
        std::string scene, changes;
      };
      const std::vector<Case> cases = {
        {lesson, exercise},
        {main_scene,
         thin_plate_and_heavy_ball + "--set 'Adaptivity/Maximum cycles=2'"},
        {main_scene, roller_on_a_thin_plate}};
      for (const Case &one : cases)
        {
          double first = 0.;
          for (const std::string kernels :
               {"Prescott", "Sandybridge", "Haswell", "Zen", "SkylakeX"})
            {
              ASSERT_EQ(execute("run " + one.scene + " --output '" +
                                  results().string() + "'" + one.changes,
                                "OPENBLAS_CORETYPE=" + kernels + " "),
                        0)
                << kernels << ": " << err;
              const double peak = last_cycle()["peak_force"];
              EXPECT_NEAR(peak, first == 0. ? peak : first, 1e-7 * peak)
                << kernels;
              first = peak;
              EXPECT_LT(last_cycle()["relative_energy_drift"], 1e-9) << kernels;
            }
        }
    }



    TEST_F(Integrators, ContactsThatCannotBePredictedAreTold)
    {
      // some four hundred contacts on nine cells
      ASSERT_EQ(run(main_scene,
                    thin_plate_and_heavy_ball +
                      "--set 'Adaptivity/Maximum cycles=1'"),
                0)
        << err;
      EXPECT_NE(err.find("cannot be predicted"), std::string::npos) << err;
      EXPECT_GT(last_cycle()["sensitivity"], 1e3);
      // three contacts that follow from each other
      ASSERT_EQ(run(SCENES "/extremes/bouncing.prm"), 0) << err;
      EXPECT_GT(last_cycle()["number_of_contacts"], 1);
      EXPECT_LT(last_cycle()["sensitivity"], 2.);
      EXPECT_EQ(err.find("cannot be predicted"), std::string::npos) << err;
      // a single one changes in proportion
      ASSERT_EQ(run(main_scene), 0) << err;
      EXPECT_FALSE(last_cycle().contains("sensitivity"));
    }



    TEST_F(Integrators, StepsOnTheMeshAreKnownToBeFewerBeforeVectorsAreMade)
    {
      // some steps to the peak, fifty contacts long
      ASSERT_EQ(run(main_scene,
                    "--set Plate/Thickness=2e-4 --set Impactor/Radius=0.002 "
                    "--set 'Time/End time=300e-6' --set 'Time/Time "
                    "step=0.4e-6' --set 'Discretization/Initial cells=24,24' "
                    "--set Adaptivity/Strategy=none --set 'Output/Write "
                    "report=false'"),
                0)
        << err;
      EXPECT_EQ(last_cycle()["work"]["ritz_vectors"], 0);
      // and that these steps are coarse is not passed over
      EXPECT_NE(err.find("Time/Time step = 4e-07 s"), std::string::npos) << err;
    }



    TEST_F(Integrators, VectorsAreNotTriedAgainWhereTheyWereMoreThanSteps)
    {
      ASSERT_EQ(run(SCENES "/compare-thin-plate.prm", half_space), 0) << err;
      bool       were_too_many = false;
      const auto cycles        = summary()["cycles"];
      for (const auto &cycle : cycles)
        {
          const auto &work = cycle["work"];
          // one attempt may be lost; those of the estimate are few
          if (were_too_many)
            {
              EXPECT_LT(work["ritz_vectors"], 40);
            }
          were_too_many = were_too_many ||
            work["linear_solves"].get<int>() > work["ritz_vectors"].get<int>();
        }
      EXPECT_TRUE(were_too_many);
    }



    TEST_F(Integrators, ErrorOfTheStepIsOfTheOrderOfTheScheme)
    {
      // on a plate that does not move
      const auto result = [this](const std::string &step) {
        EXPECT_EQ(run(main_scene,
                      "--set Plate/Density=1e12 --set 'Time/Newmark gamma=0.6' "
                      "--set 'Time/Newmark beta=0.3025' --set "
                      "Contact/Integration=collocation --set "
                      "Adaptivity/Strategy=none --set 'Time/Time step=" +
                        step + "'"),
                  0)
          << err;
        return last_cycle();
      };
      const double exact  = result("1e-9")["peak_force"];
      const auto   coarse = result("4e-7");
      const double error =
        std::abs(coarse["peak_force"].get<double>() / exact - 1.);
      EXPECT_GT(error, 1e-3);
      EXPECT_NEAR(coarse["time_error"].get<double>() / error, 1., 0.2);
      // and so is the advice
      const std::string advice = "choose at most ";
      const double      step =
        std::stod(err.substr(err.find(advice) + advice.size()));
      EXPECT_NEAR(step / (4e-7 * 1e-3 / error), 1., 0.2);
    }



    TEST_F(Integrators, ErrorOfTheStepIsToldWhereThePeakSitsOnRipples)
    {
      // a heavy ball: waves cross the plate dozens of times before the peak
      const auto result = [this](const std::string &step) {
        EXPECT_EQ(run(main_scene,
                      "--set Plate/Thickness=0.004 --set Impactor/Radius=0.02 "
                      "--set Impactor/Mass=6.24 --set Impactor/Velocity=0.3 "
                      "--set 'Time/End time=2.2e-3' --set Adaptivity/Strategy="
                      "none --set 'Discretization/Initial cells=12, 12' --set "
                      "'Time/Time step=" +
                        step + "'"),
                  0)
          << err;
        return last_cycle();
      };
      const double exact = result("2e-7")["peak_force"];
      for (const std::string step : {"6.4e-6", "3.2e-6", "1.6e-6", "8e-7"})
        {
          const auto   coarse = result(step);
          const double error =
            std::abs(coarse["peak_force"].get<double>() / exact - 1.);
          EXPECT_GT(coarse["time_error"].get<double>() / error, 1.) << step;
          EXPECT_LT(coarse["time_error"].get<double>() / error, 10.) << step;
        }
    }
  } // namespace
} // namespace PlateImpact
