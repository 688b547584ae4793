// Contacts that yield, and the finite ball: against ball and plate as bodies of
// finite elements (tests/calculix).
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace PlateImpact
{
  namespace
  {
    class Yielding : public Program
    {
    protected:
      static std::string
      set(const std::string &entry, const nlohmann::json &value)
      {
        return " --set \"" + entry + '=' +
          (value.is_null() ? "0" : value.dump()) + '"';
      }

      /// A case of tests/reference/impact_fe_cases.json as changes of the main
      /// scene; its plate is endless up to the end.
      static std::string
      changes_of(const nlohmann::json &one)
      {
        std::string changes =
          set("Plate/Thickness", one["plate"]["thickness"]) +
          set("Impactor/Radius", one["impactor"]["radius"]) +
          set("Impactor/Velocity", one["velocity"]) +
          " --set \"Plate/Side lengths=0.8, 0.8\""
          " --set \"Contact/Finite ball=true\" --set Time/Time\\ step=0"
          " --set \"Adaptivity/Goal=peak force\""
          " --set \"Adaptivity/Maximum cycles=10\"" +
          set("Time/End time", one.value("end_time", 0.));
        for (const std::string section : {"plate", "impactor"})
          {
            const std::string name =
              section == "plate" ? "Plate/" : "Impactor/";
            const auto &body = one[section];
            changes += set(name + "Young's modulus", body["E"]) +
              set(name + "Poisson's ratio", body["nu"]) +
              set(name + "Density", body["rho"]) +
              set(name + "Yield strength", body["yield_strength"]);
          }
        return changes;
      }
    };



    TEST_F(Yielding, ImpactsAgreeWithFiniteElements)
    {
      std::ifstream file(TEST_DATA "/reference/impact_fe_cases.json");
      for (const auto &one : nlohmann::json::parse(file))
        {
          SCOPED_TRACE(one["name"]);
          ASSERT_EQ(run(main_scene, changes_of(one)), 0) << err;
          const auto   last   = last_cycle();
          const bool   yields = !one["plate"]["yield_strength"].is_null();
          const double v      = one["velocity"];
          EXPECT_NEAR(last["peak_force"].get<double>() /
                        one["peak_force"].get<double>(),
                      1.,
                      yields ? 0.045 : 0.006);
          if (!one["rebound_velocity"].is_null())
            {
              EXPECT_NEAR(-last["final_impactor_velocity"].get<double>() / v,
                          one["rebound_velocity"].get<double>() / v,
                          yields ? 0.03 : 0.012);
            }
          // of both bodies together, which share it where both yield alike
          const bool both = !one["impactor"]["yield_strength"].is_null();
          if (yields && !one["dent"].is_null())
            {
              EXPECT_NEAR(last["permanent_indentation"].get<double>(),
                          (both ? 2. : 1.) * one["dent"].get<double>(),
                          1e-6);
            }
          EXPECT_LT(last["relative_energy_drift"].get<double>(), 1e-11);
          record(one["name"], last["peak_force"]);
        }
    }



    TEST_F(Yielding, SteelThatYields)
    {
      ASSERT_EQ(run(SCENES "/steel-that-yields.prm"), 0) << err;
      expect_near(last_cycle()["peak_force"], 1162.9, 0.045);
      EXPECT_EQ(summary()["outcome"], "target reached");
      // the curves of energies on the page add up
      const auto history = study_of("report.html")["histories"].back();
      EXPECT_NEAR(history["dissipated_energy"].back().get<double>() /
                    last_cycle()["dissipated_energy"].get<double>(),
                  1.,
                  1e-4);
    }



    TEST_F(Yielding, BothIntegratorsAndBothIntegrationsAgree)
    {
      const std::string steel = " --set \"Plate/Yield strength=3.55e8\""
                                " --set \"Contact/Finite ball=true\"";
      ASSERT_EQ(run(main_scene, steel), 0) << err;
      const auto vectors = last_cycle();
      ASSERT_EQ(run(main_scene, steel + " --set Time/Integrator=Newmark"), 0);
      const auto steps = last_cycle();
      ASSERT_EQ(run(main_scene,
                    steel + " --set Contact/Integration=collocation"),
                0);
      const auto collocated = last_cycle();
      for (const auto &[other, tolerance] :
           {std::pair(steps, 2e-5), std::pair(collocated, 1e-3)})
        for (const char *key : {"peak_force",
                                "permanent_indentation",
                                "dissipated_energy",
                                "final_impactor_velocity"})
          EXPECT_NEAR(other[key].get<double>() / vectors[key].get<double>(),
                      1.,
                      tolerance)
            << key;
      // kinetic, stored and dissipated energy add up
      EXPECT_LT(steps["relative_energy_drift"].get<double>(), 1e-11);
      EXPECT_GT(vectors["dissipated_energy"].get<double>(), 0.);
      EXPECT_GT(vectors["mean_pressure_over_yield_strength"].get<double>(),
                1.1);
      EXPECT_LT(vectors["mean_pressure_over_yield_strength"].get<double>(), 3.);
    }



    TEST_F(Yielding, AStrengthThatIsNotReachedChangesNothing)
    {
      ASSERT_EQ(run(main_scene), 0) << err;
      const auto elastic = last_cycle();
      ASSERT_EQ(run(main_scene, "--set \"Plate/Yield strength=2.2e9\""), 0);
      EXPECT_NEAR(last_cycle()["peak_force"].get<double>() /
                    elastic["peak_force"].get<double>(),
                  1.,
                  1e-9);
      EXPECT_EQ(last_cycle()["permanent_indentation"], 0.);
      // 2.05 GPa is what an elastic contact needs there
      ASSERT_EQ(run(main_scene, "--set \"Plate/Yield strength=2.0e9\""), 0);
      EXPECT_GT(last_cycle()["permanent_indentation"], 0.);
      // the weaker body decides
      ASSERT_EQ(run(main_scene,
                    "--set \"Plate/Yield strength=2.2e9\" "
                    "--set \"Impactor/Yield strength=5e8\""),
                0);
      EXPECT_LT(last_cycle()["peak_force"].get<double>(), 1300.);
    }



    TEST_F(Yielding, RefusesWhatHasNoLaw)
    {
      const std::string laminate = SCENES "/laminate-sun-chen.prm";
      for (const std::string entry :
           {"Plate/Yield strength", "Impactor/Yield strength"})
        {
          EXPECT_EQ(run(laminate, "--set \"" + entry + "=3e8\""), 1);
          EXPECT_NE(err.find(entry), std::string::npos) << err;
        }
      EXPECT_EQ(run(main_scene,
                    "--set Contact/Unloading=Yang-Sun "
                    "--set \"Contact/Local response=half-space\" "
                    "--set \"Plate/Yield strength=3e8\""),
                1);
      EXPECT_NE(err.find("law of laminates"), std::string::npos) << err;
      EXPECT_EQ(run(main_scene, "--set \"Plate/Yield strength=-1\""), 1);
      // megapascals without their zeros: the answer was about Young's modulus
      for (const std::string body : {"Plate", "Impactor"})
        {
          EXPECT_EQ(run(main_scene,
                        "--set \"" + body + "/Yield strength=235\""),
                    1);
          EXPECT_NE(err.find(body + "/Yield strength = 235 Pa is less than"),
                    std::string::npos)
            << err;
        }
      // a line contact stays elastic and says from where on it does not
      ASSERT_EQ(run(SCENES "/paper-cylinder.prm",
                    "--set \"Plate/Yield strength=3e8\""),
                0);
      EXPECT_NE(err.find("no yielding law for line contact"), std::string::npos)
        << err;
    }
  } // namespace
} // namespace PlateImpact
