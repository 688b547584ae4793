// What the executable writes and prints.
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
      double     of_model = 0.;
      const auto parts    = summary()["verdict"]["model"]["errors"];
      for (const auto &part : parts)
        of_model += part["relative"].get<double>();
      EXPECT_EQ(out,
                "peak_force=" + last_cycle()["peak_force"].dump() +
                  " bar=" + last_cycle()["peak_force_error_bar"].dump() +
                  " model_error=" + nlohmann::json(of_model).dump() +
                  " outcome=\"target reached\" trust=doubtful "
                  "convergence=good model=doubtful\n");
      EXPECT_EQ(summary()["verdict"]["trust"], "doubtful");
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



    TEST_F(Program, TellsTimesInTheUnitOfTheEndTime)
    {
      const std::string slow =
        "--set Discretization/Element=MITC9 --set Plate/Thickness=2e-5 --set "
        "Impactor/Velocity=6e-7 --set \"Impactor/Young's modulus=2e6\" --set "
        "'Time/End time=5' --set 'Time/Time step=0.01'";
      ASSERT_EQ(run(SCENES "/course/05-locking.prm", slow), 0) << err;
      EXPECT_NE(out.find("    at s    end s"), std::string::npos) << out;
      EXPECT_NE(out.find(" 1.84   3.8134 "), std::string::npos) << out;
      EXPECT_NE(out.find("515.8 nN, error not known\n"), std::string::npos)
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
  } // namespace
} // namespace PlateImpact
