// What the executable writes and says.
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <set>

namespace PlateImpact
{
  namespace
  {
    TEST_F(Program, WritesTheFilesOfARun)
    {
      ASSERT_EQ(run(main_scene,
                    "--set 'Adaptivity/Maximum cycles=2' --set 'Output/Field "
                    "samples=3' --set 'Time/Time step=1e-6'"),
                0)
        << err;
      for (const std::string name : {"scene.prm",
                                     "summary.json",
                                     "report.html",
                                     "contact_history.csv",
                                     "contact_history_cycle_1.csv",
                                     "element_errors_cycle_1.csv",
                                     "element_errors_cycle_2.csv",
                                     "mesh_cycle_1.svg",
                                     "mesh_cycle_2.svg",
                                     "fields.pvd",
                                     "fields_0.vtu",
                                     "fields_2.vtu"})
        EXPECT_TRUE(fs::exists(results() / name)) << name;
      EXPECT_EQ(summary()["outcome"], "maximum cycles");

      std::istringstream history(text(results() / "contact_history.csv"));
      std::string        line;
      std::getline(history, line);
      EXPECT_EQ(
        line,
        "time,force,indentation,plate_displacement,impactor_displacement,"
        "impactor_velocity,plate_energy,contact_energy,impactor_energy");
      unsigned int n_rows = 0;
      double       peak   = 0.;
      while (std::getline(history, line))
        {
          ++n_rows;
          peak = std::max(peak, std::stod(line.substr(line.find(',') + 1)));
        }
      EXPECT_EQ(n_rows, 81u);
      EXPECT_EQ(peak, last_cycle()["peak_force"].get<double>());

      // the scene that was written repeats the run
      const double first_peak = last_cycle()["peak_force"];
      fs::copy(results() / "scene.prm", directory / "again.prm");
      ASSERT_EQ(run((directory / "again.prm").string()), 0) << err;
      EXPECT_EQ(last_cycle()["peak_force"].get<double>(), first_peak);
      EXPECT_TRUE(fs::exists(results() / "fields_2.vtu"));
    }



    TEST_F(Program, ResultsOfAnEarlierRunDoNotStay)
    {
      ASSERT_EQ(run(main_scene, "--quiet --set 'Time/Time step=1e-6'"), 0);
      // one line for scripts
      EXPECT_EQ(out,
                "peak_force=" + last_cycle()["peak_force"].dump() +
                  " bar=" + last_cycle()["peak_force_error_bar"].dump() +
                  " outcome=\"target reached\" trust=good "
                  "convergence=good model=good\n");
      EXPECT_EQ(summary()["verdict"]["trust"], "good");
      ASSERT_EQ(run(main_scene,
                    "--set Adaptivity/Strategy=none --set 'Output/Write "
                    "report=false' --set 'Time/Time step=1e-6'"),
                0);
      EXPECT_FALSE(fs::exists(results() / "contact_history_cycle_1.csv"));
      EXPECT_FALSE(fs::exists(results() / "element_errors_cycle_1.csv"));
      EXPECT_FALSE(fs::exists(results() / "report.html"));
    }



    /// Keys of an object and of all within, but those of inputs.
    void
    add_keys(const nlohmann::json &value, std::set<std::string> &keys)
    {
      if (!value.is_structured())
        return;
      for (const auto &[key, within] : value.items())
        {
          if (value.is_object())
            keys.insert(key);
          if (key != "inputs")
            add_keys(within, keys);
        }
    }



    TEST_F(Program, EveryResultIsDocumented)
    {
      const std::string     page = text(TEST_DATA "/../doc/results.md");
      std::set<std::string> names;
      for (const std::string sets :
           {"'" SCENES
            "/laminate-sun-chen.prm' --set Contact/Unloading=Yang-Sun "
            "--set 'Ply/Mode II toughness=500' "
            "--set Adaptivity/Verify=true --set 'Output/Natural frequencies=1'",
            "'" SCENES "/paper-sphere.prm'",
            "'" SCENES "/sphere-on-steel-plate.prm'"})
        {
          ASSERT_EQ(execute("run " + sets + " --output '" + results().string() +
                            "'"),
                    0)
            << err;
          add_keys(summary(), names);
          for (const std::string table :
               {"contact_history.csv", "element_errors_cycle_1.csv"})
            {
              std::istringstream rows(text(results() / table));
              std::string        header, name;
              std::getline(rows, header);
              std::istringstream columns(header);
              while (std::getline(columns, name, ','))
                names.insert(name);
            }
        }
      EXPECT_GT(names.size(), 70u);
      for (const std::string &name : names)
        EXPECT_NE(page.find('`' + name + '`'), std::string::npos) << name;
      EXPECT_EQ(summary()["inputs"]["Plate/Thickness"], "0.008");
    }



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
      // heavier than the plate: nothing that Zener's equation knows
      ASSERT_EQ(execute("check '" SCENES "/extremes/heavy-impactor.prm'"), 0);
      EXPECT_NEAR(force() / 822.6, 1., 0.03) << out;
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
      EXPECT_NE(out.find("step, end time, cost  cannot be said"),
                std::string::npos)
        << out;
    }



    TEST_F(Program, CheckKnowsCellsToAFactorOfAboutFour)
    {
      // waves and a hole take more, a light ball fewer
      for (const std::string scene : {SCENES "/drilled-plate.prm",
                                      SCENES "/extremes/fast-impact.prm",
                                      SCENES "/extremes/light-impactor.prm"})
        {
          ASSERT_EQ(execute("check '" + scene + "'"), 0) << err;
          const std::string words = "of the order of ";
          ASSERT_NE(out.find(words), std::string::npos) << out;
          const double expected =
            std::stod(out.substr(out.find(words) + words.size()));
          ASSERT_EQ(run(scene), 0) << err;
          EXPECT_EQ(summary()["outcome"], "target reached");
          const double ratio = expected / last_cycle()["cells"].get<double>();
          EXPECT_GT(ratio, 1. / 4.5) << scene;
          EXPECT_LT(ratio, 4.5) << scene;
        }
    }



    TEST_F(Program, TellsTimesInTheUnitOfTheEndTime)
    {
      const std::string slow =
        "--set Discretization/Element=MITC9 --set Plate/Thickness=2e-5 --set "
        "Impactor/Velocity=6e-7 --set \"Impactor/Young's modulus=2e6\" --set "
        "'Time/End time=5' --set 'Time/Time step=0.01'";
      ASSERT_EQ(run(SCENES "/course/05-locking.prm", slow), 0) << err;
      EXPECT_NE(out.find("    at s    end s"), std::string::npos) << out;
      EXPECT_NE(out.find(" 1.73   3.8022 "), std::string::npos) << out;
      EXPECT_NE(out.find("515.7 nN at 1.73 s (error not known)\n"),
                std::string::npos)
        << out;
    }



    TEST_F(Program, MeshPicturesAndAdviceHaveTheNumbersThatTheyNeed)
    {
      ASSERT_EQ(run(SCENES "/extremes/large-patch.prm"), 0) << err;
      // coordinates to better than two digits
      const std::string picture = text(results() / "mesh_cycle_1.svg");
      EXPECT_EQ(picture.find("e+"), std::string::npos);
      EXPECT_NE(picture.find("y=\"160.43181\">3<"), std::string::npos);
      // the radius itself, since 0 may not lead there
      EXPECT_NE(err.find("choose Contact/Patch radius = 0.00048"),
                std::string::npos)
        << err;
      // a drop that nobody can see is not warned of
      ASSERT_EQ(run(SCENES "/course/05-locking.prm",
                    "--set 'Contact/Load distribution=point'"),
                0)
        << err;
      EXPECT_EQ(err.find("per halving"), std::string::npos) << err;
    }



    TEST_F(Program, ManyAndLongMistakesFitOnAScreen)
    {
      std::ofstream scene(directory / "bad.prm");
      for (unsigned int n = 0; n < 1000; ++n)
        scene << "junk " << std::string(5000, 'x') << '\n';
      scene.close();
      EXPECT_EQ(execute("check '" + (directory / "bad.prm").string() + "'"), 1);
      EXPECT_NE(err.find("and 980 more mistakes"), std::string::npos);
      EXPECT_LT(err.size(), 20000u);
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
  } // namespace
} // namespace PlateImpact
