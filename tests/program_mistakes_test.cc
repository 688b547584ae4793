// Wrong input, wrong command lines and failures: exit statuses and what is
// left.
#include "program_fixture.h"
#include "test_plate.h"

#include <gtest/gtest.h>

#include <map>

namespace PlateImpact
{
  namespace
  {
    TEST_F(Program, WrongInputLeavesNothingBehind)
    {
      const std::string scene = write_scene("subsection Plate\n"
                                            "  set Thicknes = 1\n"
                                            "  set Density  = -1\n"
                                            "end\n");
      EXPECT_EQ(run(scene), 1);
      EXPECT_EQ(
        err,
        "plate-impact: " + scene +
          ":2: there is no entry 'Thicknes' in section Plate; did you "
          "mean 'Thickness'?\n"
          "plate-impact: " +
          scene +
          ":3: Plate/Density = -1 is not allowed; expected a number above "
          "0\n");
      EXPECT_FALSE(fs::exists(results()));
    }



    TEST_F(Program, SceneIsNotReplacedByItsResults)
    {
      const std::string scene = write_scene("# mine\n");
      EXPECT_EQ(execute("run '" + scene + "' --output '" + directory.string() +
                        "'"),
                1);
      EXPECT_NE(err.find("holds the scene itself"), std::string::npos) << err;
      EXPECT_EQ(text(scene), "# mine\n");
    }



    TEST_F(Program, CoarseStepsAreWarnedOfAndAbsurdOnesRefused)
    {
      EXPECT_EQ(run(main_scene,
                    "--set 'Time/Time step=20e-6' --set 'Contact/Patch "
                    "radius=0.0005'"),
                0)
        << err;
      EXPECT_NE(err.find("coarsely"), std::string::npos) << err;
      EXPECT_LT(last_cycle()["relative_energy_drift"], 1e-10);
      EXPECT_EQ(run(main_scene,
                    "--set 'Time/Time step=1' --set 'Time/End time=10'"),
                1);
      EXPECT_NE(err.find("25 times as long as the contact"), std::string::npos)
        << err;
    }



    TEST_F(Program, EstimatorTakesEnoughSamplesWhateverTheInterval)
    {
      ASSERT_EQ(run(main_scene), 0) << err;
      const double expected = summary()["cycles"][0]["discretization_error"];
      ASSERT_EQ(run(main_scene, "--set 'Adaptivity/Sampling interval=100000'"),
                0)
        << err;
      expect_near(summary()["cycles"][0]["discretization_error"],
                  expected,
                  5e-3);
    }



    TEST_F(Program, WrongCommandLinesExitWithOne)
    {
      EXPECT_EQ(execute(""), 1);
      EXPECT_EQ(execute("fly"), 1);
      EXPECT_EQ(execute("run"), 1);
      EXPECT_EQ(execute("sweep '" + main_scene + "'"), 1);
      EXPECT_EQ(err,
                "plate-impact: " + main_scene +
                  ": nothing is swept; expected Sweep/Entry 1 and Values 1, "
                  "for example Impactor/Velocity and 1, 2, 5\n");
      EXPECT_EQ(execute("check '" + main_scene + "' --set Plate/Density=-1"),
                1);
      EXPECT_EQ(WEXITSTATUS(std::system(
                  ("'" PROGRAM "' defaults > /dev/full 2> /dev/null"))),
                2);
      EXPECT_EQ(run(main_scene, "--set foo --set Plate/Densty=1 --set x#=1"),
                1);
      EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 3) << err;
      EXPECT_EQ(run(main_scene, "--set Plate/Thickness = 0.01"), 1);
      EXPECT_EQ(err,
                "plate-impact: '=' stands alone; write a change without blanks "
                "around '=', as in --set 'Section/Entry=value'\n");
      EXPECT_EQ(run("no-such-scene.prm"), 1);
      EXPECT_EQ(err,
                "plate-impact: no-such-scene.prm: there is no such scene\n");
      EXPECT_EQ(run(main_scene, "--set 'Time/Endtime=1'"), 1);
      EXPECT_EQ(err,
                "plate-impact: --set: there is no entry 'Endtime' in section "
                "Time; did you mean 'End time'?\n");
      EXPECT_EQ(execute("--help"), 0);
      EXPECT_EQ(execute("--version"), 0);
      const std::string version = out.substr(out.find_last_of(' ') + 1);
      EXPECT_NE(
        text(TEST_DATA "/../CITATION.cff").find("\nversion: " + version),
        std::string::npos)
        << version;
      EXPECT_NE(text(TEST_DATA "/../CHANGELOG.md")
                  .find("\n## " + version.substr(0, version.find('\n')) +
                        ", 20"),
                std::string::npos)
        << version;
      EXPECT_EQ(out.substr(0, 13), "plate-impact ");
    }



    TEST_F(Program, OutputThatCannotBeWrittenIsTold)
    {
      std::ofstream(directory / "results") << "a file in the way";
      EXPECT_EQ(run(main_scene), 1);
      EXPECT_NE(err.find("is a file, or within one"), std::string::npos) << err;
      EXPECT_EQ(err.find("Stacktrace"), std::string::npos);
    }



    TEST_F(Program, PathsThatAreNoFilesAreRefused)
    {
      EXPECT_EQ(run(directory.string()), 1);
      EXPECT_EQ(err,
                "plate-impact: " + directory.string() +
                  ": the scene cannot be read\n");
      EXPECT_EQ(execute("run '" + main_scene + "' --output /proc/results"), 2);
      EXPECT_NE(err.find("/proc/results cannot be created"), std::string::npos)
        << err;
    }



    TEST_F(Program, FullDiskLeavesValidFiles)
    {
      // a file system of 200 KB in a name space of its own: room for the files
      // of the first cycle and not for those of the second
      const std::string name_space =
        std::system("unshare --mount true 2> /dev/null") == 0 ?
        "unshare --mount" :
        "unshare --map-root-user --mount";
      if (std::system((name_space + " true 2> /dev/null").c_str()) != 0)
        GTEST_SKIP() << "file systems cannot be mounted here";
      fs::create_directories(directory / "disk");
      const std::string script = "cd '" + directory.string() +
        "' && mount -t tmpfs -o size=200k none disk && "
        "{ '" PROGRAM "' run '" +
        main_scene + "' --output disk/results 2> err > out; " +
        "echo $? > status; cp -r disk/results results; }";
      std::ofstream(directory / "script") << script;
      ASSERT_EQ(std::system(
                  (name_space + " sh '" + (directory / "script").string() + "'")
                    .c_str()),
                0);
      EXPECT_EQ(text(directory / "status"), "2\n");
      EXPECT_NE(text(directory / "err")
                  .find("contact_history.csv cannot be "
                        "written"),
                std::string::npos)
        << text(directory / "err");
      bool has_first_cycle = false;
      for (const auto &entry : fs::directory_iterator(results()))
        {
          EXPECT_NE(entry.path().extension(), ".incomplete") << entry;
          has_first_cycle |= entry.path().filename() == "mesh_cycle_1.svg";
          const bool is_summary = entry.path().filename() == "summary.json";
          EXPECT_TRUE(!is_summary ||
                      summary()["outcome"].get<std::string>().substr(0, 6) ==
                        "failed");
        }
      EXPECT_TRUE(has_first_cycle);
    }



    TEST_F(Program, FailedComputationNamesTheStepAndLeavesValidFiles)
    {
      // a plate so heavy that its matrices overflow
      EXPECT_EQ(run(main_scene,
                    "--set Plate/Density=1e300 --set Time/Integrator=Newmark "
                    "--set 'Contact/Patch "
                    "radius=0.001'"),
                2)
        << out << err;
      EXPECT_NE(err.find("step 1"), std::string::npos) << err;
      EXPECT_EQ(summary()["outcome"].get<std::string>().substr(0, 6), "failed");
      EXPECT_TRUE(fs::exists(results() / "scene.prm"));
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



    TEST_F(Program, SaysWhatToWriteInPlaceOfUnitsAndOtherWords)
    {
      const std::map<std::string, std::string> cases = {
        {"Plate/Thickness=8 mm", "; write 0.008, in m"},
        {"Plate/Thickness=8mm", "; write 0.008, in m"},
        {"Plate/Thickness=0,008", "; write 0.008, with a point"},
        {"Impactor/Mass=2000 g", "; write 2, in kg"},
        {"Plate/Side lengths=40 cm, 250mm", "; write 0.4, 0.25, in m"},
        {"Impactor/Velocity=200 mm/s", "; write 0.2, in m/s"},
        {"Plate/Young's modulus=210 GPa", "; write 2.1e+11, in Pa"},
        {"Plate/Density=2.7 g/cm^3", "; write 2700, in kg/m^3"},
        {"Time/End time=80 us", "; write 8e-05, in s"},
        {"Adaptivity/Target error=5%", "; write 0.05"},
        {"Plate/Support=fixed", "; did you mean 'clamped'?"},
        {"Plate/Support=hinged", "; did you mean 'simply supported'?"},
        {"Impactor/Shape=ball", "; did you mean 'sphere'?"},
        {"Plate/Young's modulus=210",
         "210 Pa is softer than any solid; did you mean 210e9?"},
        {"Plate/Density=7.8",
         "7.8 kg/m^3 is lighter than any solid; did you mean 7800?"},
        {"Impactor/Density=2.7", "did you mean 2700?"},
        {"Plate/Young's modulus=210000", "did you mean 210000e6?"},
        {"Impactor/Diameter=0.02", "; expected Shape, Radius, Length, Mass, "},
        {"Ball/Radius=0.02", "; expected Plate, Ply, Impactor, Contact, "},
        // not of this entry, and no unit at all
        {"Plate/Thickness=8 kg", "expected a number above 0\n"},
        {"Plate/Thickness=8 apples", "expected a number above 0\n"},
        {"Plate/Support=glued", "pairs edge: word\n"}};
      for (const auto &[change, hint] : cases)
        {
          EXPECT_EQ(execute("check '" + main_scene + "' --set \"" + change +
                            '"'),
                    1)
            << change;
          EXPECT_NE(err.find(hint), std::string::npos) << change << '\n' << err;
        }
      // other units, all of them
      EXPECT_EQ(execute("check '" SCENES "/extremes/millimetres.prm'"), 0)
        << err;
    }
  } // namespace
} // namespace PlateImpact
