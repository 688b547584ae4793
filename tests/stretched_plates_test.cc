// Whole impacts on plates that stretch.
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

namespace PlateImpact
{
  namespace
  {
    class StretchedPlates : public Program
    {
    protected:
      const std::string coarse = " --set 'Adaptivity/Strategy=none'"
                                 " --set 'Discretization/Initial cells=4, 4'";

      /// The main scene on a thin plate that stretches.
      int
      run_large(const std::string &more)
      {
        return run(SCENES "/sphere-on-steel-plate.prm",
                   "--set Plate/Deflection=large --set Plate/Thickness=0.002 " +
                     coarse + more);
      }
    };



    // Axisymmetric elements of high order; the forces sit on ripples. The other
    // cases are in doc/validation.md.
    TEST_F(StretchedPlates, AHeavyBallIsThatOfTheReference)
    {
      const auto  given = reference("stretch_cases.json").back();
      const auto &plate = given["plate"], &ball = given["impactor"];
      ASSERT_EQ(given["name"], "aluminium_1mm_heavy_0.5mps");
      std::string changes;
      const auto  set = [&changes](const std::string    &path,
                                  const nlohmann::json &value) {
        changes += " --set \"" + path + "=" + value.dump() + "\"";
      };
      set("Plate/Thickness", plate["thickness"]);
      set("Plate/Young's modulus", plate["E"]);
      set("Plate/Poisson's ratio", plate["nu"]);
      set("Plate/Density", plate["rho"]);
      set("Contact/Patch radius", plate["patch_radius"]);
      set("Impactor/Radius", ball["radius"]);
      set("Impactor/Mass", ball["mass"]);
      set("Impactor/Velocity", given["velocity"]);
      set("Time/End time", given["end_time"]);
      const std::string diameter =
        std::to_string(2. * plate["radius"].get<double>());
      changes +=
        " --set 'Plate/Side lengths=" + diameter + ", " + diameter + "'";
      for (const std::string theory : {"large", "linear"})
        {
          ASSERT_EQ(run(SCENES "/aluminium-sheet.prm",
                        changes + " --set Plate/Deflection=" + theory),
                    0)
            << err;
          const auto  last     = last_cycle();
          const auto &expected = given[theory];
          EXPECT_NEAR(last["max_plate_displacement"].get<double>() /
                        expected["max_plate_displacement"].get<double>(),
                      1.,
                      0.01)
            << theory;
          EXPECT_NEAR(last["final_impactor_velocity"].get<double>(),
                      expected["velocity_at_end"].get<double>(),
                      0.02 * given["velocity"].get<double>())
            << theory;
          EXPECT_LT(last["relative_energy_drift"], 1e-9);
        }
    }



    // Ball and plate as elastic bodies with finite rotations (CalculiX,
    // NLGEOM): no plate theory, no law of contact.
    TEST_F(StretchedPlates, AgreeWithElasticBodies)
    {
      const auto  given = reference("calculix_stretch_cases.json").front();
      const auto &plate = given["plate"], &ball = given["impactor"];
      const auto &bodies = given["runs"].back();
      const auto  value  = [](const nlohmann::json &number) {
        return number.dump() + "'";
      };
      const std::string side =
        std::to_string(2. * plate["radius"].get<double>());
      ASSERT_EQ(
        run(SCENES "/aluminium-sheet.prm",
            "--set 'Plate/Side lengths=" + side + ", " + side +
              "' --set 'Plate/Thickness=" + value(plate["thickness"]) +
              " --set 'Impactor/Radius=" + value(ball["radius"]) +
              " --set 'Impactor/Mass=0' --set 'Impactor/Density=" +
              value(ball["rho"]) +
              " --set 'Impactor/Velocity=" + value(given["velocity"]) +
              " --set 'Time/End time=" + value(given["end_time"]) +
              " --set 'Contact/Local response=layer' --set 'Contact/Patch "
              "radius=0' --set 'Adaptivity/Target error=0.03'"),
        0)
        << err;
      const auto last = last_cycle();
      for (const char *quantity : {"max_plate_displacement", "peak_force"})
        EXPECT_NEAR(last[quantity].get<double>() /
                      bodies[quantity].get<double>(),
                    1.,
                    0.02)
          << quantity;
      EXPECT_NEAR(-last["final_impactor_velocity"].get<double>(),
                  bodies["rebound_velocity"].get<double>(),
                  0.02 * given["velocity"].get<double>());
    }



    TEST_F(StretchedPlates, SlowBallsStrikeALinearPlate)
    {
      const std::string slow = " --set Impactor/Velocity=0.001 --set "
                               "'Time/Integrator=Newmark'";
      ASSERT_EQ(run_large(slow), 0) << err;
      const auto large = last_cycle();
      ASSERT_EQ(run_large(slow + " --set Plate/Deflection=linear"), 0) << err;
      for (const char *quantity :
           {"peak_force", "max_plate_displacement", "final_impactor_velocity"})
        EXPECT_NEAR(large[quantity].get<double>() /
                      last_cycle()[quantity].get<double>(),
                    1.,
                    1e-4)
          << quantity;
    }



    TEST_F(StretchedPlates, EnergyIsKeptAtAnyStep)
    {
      for (const std::string step : {"2e-7", "2e-6", "2e-5"})
        {
          ASSERT_EQ(run_large(" --set Impactor/Velocity=30 --set 'Time/End "
                              "time=4e-4' --set 'Time/Time step=" +
                              step + "'"),
                    0)
            << err;
          EXPECT_GT(last_cycle()["max_plate_displacement"], 0.002);
          EXPECT_LT(last_cycle()["relative_energy_drift"], 1e-9) << step;
        }
    }



    TEST_F(StretchedPlates, TheEndIsFoundInStepsThatConverge)
    {
      // a light laminate that a soft ball throws away: four times the step is
      // too long for it
      ASSERT_EQ(run(write_scene("subsection Plate\n"
                                "set Side lengths = 0.19, 0.13\n"
                                "set Thickness = 0.0063\n"
                                "set Support = free\n"
                                "set Density = 43\n"
                                "set Layup = 45/-45/0/90s\n"
                                "set Deflection = large\n"
                                "end\n"
                                "subsection Impactor\n"
                                "set Radius = 0.006\n"
                                "set Young's modulus = 2.2e6\n"
                                "set Mass = 0.039\n"
                                "set Velocity = 0.66\n"
                                "end\n"
                                "subsection Time\n"
                                "set End time = 0\n"
                                "set Time step = 0\n"
                                "end\n"),
                    coarse),
                0)
        << err;
      EXPECT_EQ(last_cycle()["number_of_contacts"], 1);
      EXPECT_LT(last_cycle()["first_contact_end"], last_cycle()["end_time"]);
    }



    TEST_F(StretchedPlates, VerifyGivesTheBar)
    {
      const std::string faster = " --set Impactor/Velocity=10 --set 'Time/Time "
                                 "step=1e-6'";
      ASSERT_EQ(run_large(faster), 0) << err;
      EXPECT_FALSE(last_cycle().contains("peak_force_error_bar"));
      ASSERT_EQ(run_large(faster + " --set Adaptivity/Verify=true"), 0) << err;
      const auto   last   = last_cycle();
      const double change = last["verification"]["relative_change"];
      EXPECT_NE(change, 0.);
      EXPECT_GE(last["peak_force_error_bar"], 2. * std::abs(change));
      EXPECT_NE(out.find(" N +- "), std::string::npos) << out;
      // four times as many cells along a side
      ASSERT_EQ(run_large(faster +
                          " --set 'Discretization/Initial cells=16, "
                          "16'"),
                0)
        << err;
      EXPECT_LT(std::abs(last_cycle()["peak_force"].get<double>() /
                           last["peak_force"].get<double>() -
                         1.),
                last["peak_force_error_bar"]);
    }



    TEST_F(StretchedPlates, DampingIsInTheBalance)
    {
      ASSERT_EQ(run_large(" --set Impactor/Velocity=10 --set 'Time/End "
                          "time=4e-4' --set 'Time/Time step=2e-6' --set "
                          "'Plate/Loss factor=0.01'"),
                0)
        << err;
      EXPECT_GT(last_cycle()["plate_dissipated_energy"], 0.);
      EXPECT_LT(last_cycle()["relative_energy_drift"], 1e-9);
    }



    TEST_F(StretchedPlates, AHalfIsTheTwoQuarters)
    {
      const std::string sliding =
        " --set 'Plate/In-plane support=sliding, held' --set "
        "Impactor/Velocity=10 --set 'Time/Time step=1e-6'";
      ASSERT_EQ(run_large(sliding), 0) << err;
      const double quarter = last_cycle()["peak_force"];
      ASSERT_EQ(run_large(sliding +
                          " --set 'Plate/Impact point=1e-12, 0' "
                          "--set 'Discretization/Initial cells=8, "
                          "4'"),
                0)
        << err;
      EXPECT_NEAR(last_cycle()["peak_force"].get<double>() / quarter, 1., 1e-6);
    }



    TEST_F(StretchedPlates, FieldsShowWhatStretches)
    {
      ASSERT_EQ(run_large(" --set Impactor/Velocity=10 --set 'Time/Time "
                          "step=1e-6' --set 'Output/Field samples=1'"),
                0)
        << err;
      const std::string fields = text(results() / "fields_0.vtu");
      for (const char *name : {"displacement_x", "membrane_force_xy"})
        EXPECT_NE(fields.find(name), std::string::npos) << name;
      EXPECT_NE(text(results() / "report.html").find("membrane force N_x"),
                std::string::npos);
      // the middle of the plate is pulled under the load, both ways alike
      const auto recovered =
        study_of("report.html")["stresses"][0]["lines"][0]["recovered"];
      const double along_x = recovered[5][0], along_y = recovered[6][0];
      EXPECT_GT(along_x, 100.);
      EXPECT_NEAR(along_y / along_x, 1., 1e-6);
    }
  } // namespace
} // namespace PlateImpact
