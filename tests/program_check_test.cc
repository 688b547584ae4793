// What `check` says.
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

namespace PlateImpact
{
  namespace
  {
    TEST_F(Program, CheckSaysWhatToExpect)
    {
      ASSERT_EQ(execute("check '" + main_scene + "'"), 0) << err;
      // from the edge of the patch to that of the plate and back
      EXPECT_NE(out.find("back at 34.8 us"), std::string::npos) << out;
      EXPECT_NE(out.find("valid scene"), std::string::npos) << out;
      const auto force = [this] {
        return std::stod(out.substr(out.find("about ") + 6));
      };
      EXPECT_NEAR(force() / elastic_peak, 1., 0.02) << out;
      // a step that the program chooses is not called the scene's
      EXPECT_NE(out.find("the scene's 1e-07 s"), std::string::npos) << out;
      ASSERT_EQ(execute("check '" + main_scene + "' --set 'Time/Time step=0'"),
                0)
        << err;
      EXPECT_NE(out.find("0: the program chooses it; "), std::string::npos)
        << out;
      // heavier than the plate: nothing that Zener's equation knows
      ASSERT_EQ(execute("check '" SCENES "/extremes/heavy-impactor.prm'"), 0);
      EXPECT_NEAR(force() / 822.6, 1., 0.03) << out;
      EXPECT_NE(out.find("late: the fastest waves cross the plate"),
                std::string::npos)
        << out;
      // and a plate that waves cross 49 times before the peak
      const std::string shaken =
        " --set Plate/Outline=circle --set 'Plate/Side lengths=0.25, 0.25' "
        "--set Plate/Thickness=0.005 --set \"Plate/Young's modulus=7e10\" "
        "--set \"Plate/Poisson's ratio=0.33\" --set Plate/Density=2700 --set "
        "'Plate/Support=simply supported' --set Impactor/Radius=0.012 --set "
        "Impactor/Mass=2 --set Impactor/Velocity=0.6 --set 'Time/End time=0' "
        "--set 'Time/Time step=0' --set 'Adaptivity/Goal=peak force' --set "
        "'Adaptivity/Target peak force error=0.05'";
      ASSERT_EQ(run(main_scene, shaken), 0) << err;
      ASSERT_EQ(execute("check '" + main_scene + "'" + shaken), 0) << err;
      EXPECT_NEAR(force() / last_cycle()["peak_force"].get<double>(), 1., 0.1)
        << out;
      ASSERT_EQ(execute("check '" SCENES "/paper-cylinder.prm'"), 0);
      EXPECT_NEAR(force() / 9091., 1., 0.03) << out;
      // a roller whose waves are shorter than those of Zener's infinite plate,
      // which gives a third of the force
      const std::string roller =
        " --set 'Plate/Side lengths=0.3, 0.2' --set Plate/Thickness=0.005 --set "
        "\"Plate/Young's modulus=70e9\" --set Plate/Density=2700 --set "
        "Impactor/Velocity=2 --set 'Contact/Load distribution=strip' --set "
        "'Adaptivity/Maximum cycles=3'";
      ASSERT_EQ(run(SCENES "/paper-cylinder.prm", roller), 0) << err;
      ASSERT_EQ(execute("check '" SCENES "/paper-cylinder.prm'" + roller), 0);
      EXPECT_NEAR(force() / last_cycle()["peak_force"].get<double>(), 1., 0.03)
        << out;
      for (const std::string scene :
           {SCENES "/paper-sphere.prm", SCENES "/paper-cylinder.prm"})
        EXPECT_EQ(execute("check '" + scene + "'"), 0) << err;
      EXPECT_EQ(execute("check '" + main_scene + "' --set Impactor/Shape=none"),
                0)
        << err;
    }



    TEST_F(Program, CheckSaysWhatALatePeakCosts)
    {
      for (const std::string target : {"0.01", "0.003"})
        {
          const std::string changes =
            " --set 'Adaptivity/Target peak force error=" + target + "'";
          ASSERT_EQ(execute("check '" SCENES "/drop-weight.prm'" + changes), 0)
            << err;
          const std::string cost = "of the order of ";
          const double      cells =
            std::stod(out.substr(out.find(cost) + cost.size()));
          ASSERT_EQ(run(SCENES "/drop-weight.prm", changes), 0) << err;
          EXPECT_LT(std::abs(
                      std::log2(cells / last_cycle()["cells"].get<int>())),
                    1.)
            << cells << " for " << last_cycle()["cells"];
        }
    }



    TEST_F(Program, CheckKnowsThatTheStepFalls)
    {
      // a small target asks for shorter steps on the third mesh than on the two
      // that are computed
      const std::string changes =
        " --set Plate/Thickness=0.004 --set Impactor/Radius=0.02"
        " --set Impactor/Mass=6.24 --set Impactor/Velocity=0.3"
        " --set 'Time/End time=0' --set 'Time/Time step=0'"
        " --set 'Adaptivity/Goal=peak force'"
        " --set 'Adaptivity/Target peak force error=1.5e-3'"
        " --set 'Adaptivity/Maximum cycles=3'";
      ASSERT_EQ(execute("check '" + main_scene + "'" + changes), 0) << err;
      const std::size_t end = out.find(" steps a mesh");
      ASSERT_NE(end, std::string::npos) << out;
      const double expected =
        std::stod(out.substr(out.rfind(' ', end - 1), end));
      ASSERT_EQ(run(main_scene, changes), 0) << err;
      const double steps = last_cycle()["steps"];
      EXPECT_GT(steps, 2. * summary()["cycles"][1]["steps"].get<double>());
      EXPECT_LT(std::abs(std::log2(expected / steps)), 1.)
        << expected << " for " << steps;
    }



    TEST_F(Program, CheckKnowsThinPlatesAsWell)
    {
      struct Case
      {
        std::string changes;
        double      force, deflection, cells; // of a run
      };
      // the plate gives way, and the contact is not over at the end of the run
      const std::vector<Case> cases = {
        {"--set Plate/Thickness=1e-3", 93.4, 68e-6, 700.},
        {"--set Plate/Thickness=4e-4 --set Impactor/Velocity=0.1",
         1.554,
         7.6e-6,
         1300.}};
      const auto number_after = [this](const std::string &words) {
        const std::size_t at = out.find(words);
        EXPECT_NE(at, std::string::npos) << words << '\n' << out;
        // the number, its prefix and its unit
        std::istringstream text(out.substr(at + words.size()));
        double             value = 0.;
        std::string        unit;
        text >> value >> unit;
        const std::map<char, double> prefixes = {{'n', 1e-9},
                                                 {'u', 1e-6},
                                                 {'m', 1e-3}};
        const auto                   prefix   = prefixes.find(unit.front());
        const bool                   has_prefix =
          unit.size() > 1 && std::isalpha(unit[1]) && prefix != prefixes.end();
        return has_prefix ? value * prefix->second : value;
      };
      for (const Case &one : cases)
        {
          ASSERT_EQ(execute("check '" + main_scene + "' " + one.changes), 0)
            << err;
          EXPECT_NEAR(number_after("peak force            about ") / one.force,
                      1.,
                      0.03);
          EXPECT_GT(number_after("contact time          more than "), 80e-6);
          EXPECT_NEAR(number_after("under the load ") / one.deflection,
                      1.,
                      0.05);
          const double cells = number_after("of the order of ");
          EXPECT_GT(cells, 0.5 * one.cells);
          EXPECT_LT(cells, 2. * one.cells);
          EXPECT_EQ(out.find("warning"), std::string::npos) << out;
        }
      // a line contact is none of a point
      ASSERT_EQ(execute("check '" SCENES
                        "/paper-cylinder.prm' --set Plate/Thickness=1e-3"),
                0)
        << err;
      EXPECT_NE(out.find("step, end time, cost  cannot be estimated"),
                std::string::npos)
        << out;
    }



    TEST_F(Program, CheckKnowsCellsToAFactorOfAboutTwo)
    {
      // by the first two meshes of the run, which the last ones follow
      struct Case
      {
        std::string scene, changes;
      };
      const std::string contact = " --set 'Time/End time=0' --set 'Time/Time "
                                  "step=0'";
      const std::vector<Case> cases = {
        {SCENES "/drilled-plate.prm", ""},
        {SCENES "/extremes/fast-impact.prm", ""},
        {SCENES "/extremes/light-impactor.prm", ""},
        // waves stay where they begin
        {main_scene,
         " --set 'Plate/Side lengths=1.6, 2.4' --set Plate/Thickness=0.01"
         " --set \"Plate/Young's modulus=6.4e10\" --set Plate/Density=2500"
         " --set \"Impactor/Young's modulus=3.3e9\" --set Impactor/Velocity=2"
         " --set Impactor/Density=1190" +
           contact},
        // waves are everywhere
        {main_scene,
         " --set Plate/Thickness=0.004 --set Impactor/Radius=0.02"
         " --set Impactor/Mass=6.24 --set Impactor/Velocity=0.3" +
           contact}};
      for (const auto &[scene, changes] : cases)
        {
          ASSERT_EQ(execute("check '" + scene + "'" + changes), 0) << err;
          const std::string words = "of the order of ";
          ASSERT_NE(out.find(words), std::string::npos) << out;
          const double expected =
            std::stod(out.substr(out.find(words) + words.size()));
          ASSERT_EQ(run(scene, changes), 0) << err;
          EXPECT_EQ(summary()["outcome"], "target reached");
          const double ratio = expected / last_cycle()["cells"].get<double>();
          EXPECT_GT(ratio, 1. / 2.5) << scene << changes;
          EXPECT_LT(ratio, 2.5) << scene << changes;
        }
    }
  } // namespace
} // namespace PlateImpact
