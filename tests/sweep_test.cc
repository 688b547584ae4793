// `plate-impact sweep` as a user runs it, against `plate-impact run` and the
// reference values.
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <utility>

namespace PlateImpact
{
  namespace
  {
    class Sweep : public Program
    {
    protected:
      /// Expects of a row what `run` finds for its values.
      void
      expect_run(const Row         &row,
                 const std::string &scene,
                 const std::string &more)
      {
        std::string values = more;
        for (const auto &[name, value] : row)
          if (name.find('/') != std::string::npos)
            values += " --set '" + name + "=" + value + "'";
        ASSERT_EQ(execute("run '" + scene + "' --output '" +
                          (directory / "run").string() + "' " + values),
                  0)
          << err;
        const auto last = nlohmann::json::parse(
                            text(directory / "run" / "summary.json"))["cycles"]
                            .back();
        // times are those of steps or interpolated between them
        for (const std::string name : {"peak_force",
                                       "time_of_peak_force",
                                       "first_contact_end",
                                       "number_of_contacts",
                                       "impulse",
                                       "final_impactor_velocity",
                                       "max_plate_displacement"})
          {
            ASSERT_EQ(row.at(name).empty(), !last.contains(name)) << name;
            if (!last.contains(name))
              continue;
            EXPECT_NEAR(std::stod(row.at(name)) / last[name].get<double>(),
                        1.,
                        1e-9)
              << name;
          }
        EXPECT_NEAR(std::stod(row.at("relative_energy_drift")),
                    last["relative_energy_drift"].get<double>(),
                    1e-9);
      }
    };



    const std::string on_one_mesh = "subsection Contact\n"
                                    "  set Patch radius = 0.0005\n"
                                    "end\n"
                                    "subsection Adaptivity\n"
                                    "  set Strategy = none\n"
                                    "end\n"
                                    "subsection Discretization\n"
                                    "  set Initial cells = 5, 5\n"
                                    "end\n";

    std::string
    swept(const std::string &entries)
    {
      return "subsection Sweep\n" + entries + "\nend\n";
    }



    TEST_F(Sweep, EveryPointEqualsItsRun)
    {
      const std::string scene =
        write_scene(on_one_mesh +
                    swept("set Entry 1 = Impactor/Velocity\n"
                          "set Values 1 = 0.3, 4\n"
                          "set Entry 2 = Impactor/Radius\n"
                          "set Values 2 = 0.004, 0.02\n"
                          "set Entry 3 = Plate/Thickness\n"
                          "set Values 3 = 0.003, 0.008"));
      for (const std::string integrator : {"Newmark", "Ritz vectors"})
        for (const std::string integration :
             {"energy conserving", "collocation"})
          {
            const std::string more = "--set 'Time/Integrator=" + integrator +
              "' --set 'Contact/Integration=" + integration +
              "' --set 'Time/End time=200e-6'";
            ASSERT_EQ(sweep(scene, more), 0) << err;
            EXPECT_NE(out.find("2 meshes, 2 plate models, 2 responses"),
                      std::string::npos)
              << out;
            const std::vector<Row> found = rows();
            ASSERT_EQ(found.size(), 8u);
            for (const std::size_t i : {0, 3, 6})
              expect_run(found[i], scene, more);
          }
    }



    TEST_F(Sweep, PointsThatCannotBePredictedAreTold)
    {
      // four hundred contacts on nine cells
      const std::string scene =
        write_scene(swept("set Entry 1 = Impactor/Velocity\n"
                          "set Values 1 = 4.7568e-4, 5e-4"));
      ASSERT_EQ(sweep(scene,
                      "--set Plate/Thickness=2e-4 --set Impactor/Mass=0.312 "
                      "--set 'Contact/Patch radius=1e-3' --set Contact/Law=Sun "
                      "--set 'Time/End time=0.08163' --set 'Time/Time "
                      "step=2.0407e-5' --set Adaptivity/Strategy=none"),
                0)
        << err;
      // whether the peak comes earlier or later is beyond prediction as well:
      // both points have one sentence, or each its own
      const std::regex told(
        "(1|2) of 2 points; the first: from t = [^:]* cannot be predicted:");
      int n_points = 0;
      for (std::sregex_iterator found(err.begin(), err.end(), told), none;
           found != none;
           ++found)
        n_points += std::stoi((*found)[1]);
      EXPECT_EQ(n_points, 2) << err;
    }



    TEST_F(Sweep, LoadsAndStepsAreSweptAsWell)
    {
      // patch radius 0: a load for every velocity on one plate; damped
      // schemes are stepped in full
      const std::string scene =
        write_scene(on_one_mesh +
                    swept("set Entry 1 = Impactor/Velocity\n"
                          "set Values 1 = 0.5, 2\n"
                          "set Entry 2 = Time/Newmark beta\n"
                          "set Values 2 = 0.25, 0.3025"));
      const std::string more = half_space +
        "--set 'Contact/Patch radius=0' --set Contact/Integration=collocation "
        "--set Time/Integrator=Newmark";
      ASSERT_EQ(sweep(scene, more), 0) << err;
      EXPECT_NE(out.find("1 mesh, 1 plate model, 4 responses"),
                std::string::npos)
        << out;
      for (const Row &row : rows())
        expect_run(row, scene, more);
    }



    TEST_F(Sweep, ShapesOnACircleHaveTheirOwnPlates)
    {
      // a sphere off the centre is turned onto an axis, a cylinder is not
      const std::string more =
        "--set 'Contact/Local response=half-space' "
        "--set Plate/Outline=circle --set 'Plate/Impact point=0.01, 0.01' "
        "--set 'Impactor/Length=0.01' --set 'Time/End time=2e-5'";
      for (const std::string shapes : {"sphere, cylinder", "cylinder, sphere"})
        {
          const std::string scene =
            write_scene(on_one_mesh +
                        swept("set Entry 1 = Impactor/Shape\n"
                              "set Values 1 = " +
                              shapes));
          ASSERT_EQ(sweep(scene, more), 0) << err;
          const std::vector<Row> found = rows();
          ASSERT_EQ(found.size(), 2u);
          for (const Row &row : found)
            {
              EXPECT_EQ(row.at("status"), "ok");
              expect_run(row, scene, more);
            }
        }
    }



    TEST_F(Sweep, AdaptivePointsEqualTheirRunsOrThatOfTheWorst)
    {
      const std::string scene = write_scene(
        swept("set Entry 1 = Impactor/Velocity\nset Values 1 = 1, 2"));
      ASSERT_EQ(sweep(scene, "--set 'Sweep/Adapt=each point'"), 0) << err;
      for (const Row &row : rows())
        {
          expect_run(row, scene, "");
          EXPECT_LE(std::stod(row.at("discretization_error")), 0.05);
        }
      // the faster impactor has the shorter contact
      const std::string fixed = "--set 'Contact/Patch radius=0.0005'";
      ASSERT_EQ(sweep(scene, fixed), 0) << err;
      EXPECT_NE(out.find("1 plate model, 1 response"), std::string::npos);
      expect_run(rows()[1], scene, fixed);
    }



    TEST_F(Sweep, FiguresOfAnImpactAreConsistent)
    {
      const std::string scene =
        write_scene(on_one_mesh +
                    swept("set Entry 1 = Impactor/Velocity\n"
                          "set Values 1 = 0.5, 1"));
      // Zener's ball is Hertz's half-space
      ASSERT_EQ(sweep(scene,
                      "--set 'Contact/Patch radius=0' "
                      "--set 'Contact/Finite ball=false' "
                      "--set 'Time/End time=90e-6' --set 'Plate/Side "
                      "lengths=0.4, 0.4' --set 'Discretization/Initial "
                      "cells=10, 10'"),
                0)
        << err;
      for (const Row &row : rows())
        {
          const double e = std::stod(row.at("coefficient_of_restitution"));
          EXPECT_NEAR(e,
                      -std::stod(row.at("final_impactor_velocity")) /
                        std::stod(row.at("Impactor/Velocity")),
                      1e-12);
          // energy is conserved: what the impactor has lost is in the plate
          EXPECT_NEAR(std::stod(row.at("plate_energy_fraction")),
                      1. - e * e,
                      1e-9);
          // a plate that waves do not come back in follows Zener's formula
          EXPECT_NEAR(std::stod(row.at("restitution_over_zener")), 1., 0.02);
          EXPECT_NEAR(std::stod(row.at("peak_force_over_zener")), 1., 0.02);
          EXPECT_NEAR(std::stod(row.at("contact_radius_over_thickness")),
                      0.05,
                      0.01);
        }
      // Zener's factor grows with the fifth root of the velocity
      EXPECT_NEAR(std::stod(rows()[1].at("zener_loss_factor")) /
                    std::stod(rows()[0].at("zener_loss_factor")),
                  std::pow(2., 0.2),
                  1e-12);
    }



    TEST_F(Sweep, StrengthsShareThePlate)
    {
      const std::string scene = SCENES "/steel-that-yields.prm",
                        sets  = "--set 'Adaptivity/Maximum cycles=1' ";
      ASSERT_EQ(sweep(scene,
                      sets +
                        "--set 'Sweep/Entry 1=Plate/Yield strength' --set "
                        "'Sweep/Values 1=0, 2.5e8, 5e8'"),
                0)
        << err;
      EXPECT_NE(out.find("1 plate model"), std::string::npos) << out;
      const auto points = rows();
      for (const std::size_t i : {0, 1, 2})
        {
          ASSERT_EQ(run(scene,
                        sets + "--set 'Plate/Yield strength=" +
                          points[i].at("Plate/Yield strength") + "'"),
                    0)
            << err;
          expect_near(last_cycle()["peak_force"],
                      std::stod(points[i].at("peak_force")),
                      1e-9);
        }
    }



    TEST_F(Sweep, InvalidPointsHaveTheirReasonsInTheirRows)
    {
      const std::string scene =
        write_scene(on_one_mesh +
                    swept("set Entry 1 = Plate/Thickness\n"
                          "set Values 1 = 0.008, 0.15, -1"));
      ASSERT_EQ(sweep(scene), 0) << err;
      EXPECT_EQ(err.find("warning: 2 of 3 points failed; the first: "), 0u)
        << err;
      EXPECT_EQ(rows()[0].at("status"), "ok");
      EXPECT_NE(sweep_table().find("Plate/Thickness = 0.15 m is too thick"),
                std::string::npos);
      EXPECT_NE(sweep_table().find("Plate/Thickness = -1 is not allowed"),
                std::string::npos);

      EXPECT_EQ(sweep(scene, "--set 'Sweep/Values 1=-1, -2'"), 2);
      EXPECT_NE(err.find("2 of 2 points failed"), std::string::npos);
      EXPECT_EQ(rows().size(), 2u);
      EXPECT_EQ(sweep(scene, "--set Plate/Thickness=0.01"), 1);
      EXPECT_EQ(err,
                "plate-impact: --set: Plate/Thickness = 0.01 has no meaning: "
                "the entry is swept\n");
      // what no point can be blamed for is a mistake of the scene
      EXPECT_EQ(sweep(scene, "--set 'Time/Time step=1'"), 1);
      EXPECT_EQ(err,
                "plate-impact: --set: Time/Time step = 1 s is longer than End "
                "time, 8e-05 s\n");
    }



    TEST_F(Sweep, PointsHaveTheWarningsOfARun)
    {
      const std::string scene =
        write_scene(on_one_mesh +
                    swept("set Entry 1 = Impactor/Radius\n"
                          "set Values 1 = 0.005, 0.03, 0.06") +
                    "subsection Time\n set End time = 3e-5\nend\n");
      ASSERT_EQ(sweep(scene), 0) << err;
      const std::string growing = "the force still grows at Time/End time = "
                                  "3e-05 s: the true peak force is larger; "
                                  "choose a later Time/End time";
      EXPECT_NE(err.find("warning: 2 of 3 points; the first: " + growing),
                std::string::npos)
        << err;
      EXPECT_EQ(rows()[0].at("warnings").find(growing), std::string::npos);
      for (const int row : {1, 2})
        EXPECT_NE(rows()[row].at("warnings").find(growing), std::string::npos);
      const std::string warnings = err;
      ASSERT_EQ(sweep(scene, "--resume"), 0) << err;
      EXPECT_EQ(err, warnings);
      ASSERT_EQ(execute("run '" + scene + "' --output '" +
                        (directory / "run").string() +
                        "' --set Impactor/Radius=0.06"),
                0);
      EXPECT_NE(err.find(growing), std::string::npos) << err;
    }



    TEST_F(Sweep, CheckSaysWhatItWillMake)
    {
      const std::string velocities  = "set Entry 1 = Impactor/Velocity\n"
                                      "set Values 1 = 1:2:4\n";
      const std::string thicknesses = "set Entry 2 = Plate/Thickness\n"
                                      "set Values 2 = 0.008, 0.006\n";
      const std::string masses      = "set Entry 2 = Impactor/Mass\n"
                                      "set Values 2 = 0.01, 10\n";
      const auto        numbers     = [](const std::string &text) {
        std::smatch made;
        EXPECT_TRUE(std::regex_search(
          text,
          made,
          std::regex(
            "([0-9]+) plates?(?: models?)?(?: on adapted meshes)?, (?:up to )?"
                       "([0-9]+) responses? to a load")))
          << text;
        return std::pair<std::string, std::string>(made[1], made[2]);
      };
      const std::string half_space =
        "Contact/Patch radius=0' --set 'Contact/Local response=half-space";
      const std::string until_waves_are_back =
        "Contact/Patch radius=0.0005' --set 'Time/End time=3e-4";
      for (const auto &[entries, set] :
           std::vector<std::pair<std::string, std::string>>{
             {velocities, half_space},
             {velocities, "Contact/Patch radius=0"},
             {velocities, "Contact/Patch radius=0.0005"},
             {velocities, "Sweep/Estimate error=true"},
             {velocities, "Adaptivity/Strategy=hanging nodes"},
             {velocities + thicknesses, half_space},
             {velocities + masses, until_waves_are_back},
             {velocities + thicknesses, "Adaptivity/Strategy=hanging nodes"}})
        {
          const std::string scene = write_scene(on_one_mesh + swept(entries));
          ASSERT_EQ(execute("check '" + scene + "' --set '" + set + "'"), 0)
            << err;
          const std::string expected = out;
          ASSERT_EQ(sweep(scene, "--set '" + set + "'"), 0) << err;
          EXPECT_EQ(numbers(expected), numbers(out)) << set;
          EXPECT_EQ(expected.find("would do") != expected.npos,
                    set == half_space || set == "Sweep/Estimate error=true")
            << expected;
        }
      const std::string no_sweep = write_scene(on_one_mesh);
      ASSERT_EQ(execute("check '" + no_sweep + "'"), 0) << err;
      EXPECT_EQ(out.find("Sweep"), out.npos);
    }



    // the second point found what the first one had left half made
    TEST_F(Sweep, PointsAfterOneWithoutMatricesFailAlike)
    {
      const std::string scene = write_scene(
        on_one_mesh +
        swept("set Entry 1 = Impactor/Velocity\nset Values 1 = 1, 2\n"));
      std::string sets;
      for (const std::string set : {"Plate/Thickness=1e-9",
                                    "Plate/Loss factor=0.01",
                                    "Impactor/Radius=1e-6",
                                    "Contact/Patch radius=1e-7",
                                    "Time/Time step=1e-10",
                                    "Time/End time=1e-8"})
        sets += " --set '" + set + "'";
      EXPECT_EQ(sweep(scene, sets), 2) << out;
      EXPECT_NE(err.find("2 of 2 points failed; the first: round-off hides the "
                         "lowest natural frequencies"),
                std::string::npos)
        << err;
    }



    TEST_F(Sweep, ResumesWhereItWasInterrupted)
    {
      const std::string scene =
        write_scene(on_one_mesh +
                    swept("set Entry 1 = Impactor/Velocity\n"
                          "set Values 1 = 1:2:9"));
      ASSERT_EQ(sweep(scene), 0) << err;
      const std::string whole = sweep_table();

      // four rows, the fourth of them cut
      std::size_t end = 0;
      for (unsigned int line = 0; line < 5; ++line)
        end = whole.find('\n', end + 1);
      std::ofstream(results() / "sweep.csv") << whole.substr(0, end - 10);
      ASSERT_EQ(sweep(scene, "--resume"), 0) << err;
      EXPECT_NE(out.find("3 of them done before"), std::string::npos) << out;
      EXPECT_NE(out.find("Computed    6 points"), std::string::npos) << out;
      EXPECT_EQ(sweep_table(), whole);

      EXPECT_EQ(sweep(scene, "--resume --set Plate/Thickness=0.009"), 1);
      EXPECT_NE(err.find("belongs to another sweep: it has 'set Thickness"),
                std::string::npos)
        << err;
      EXPECT_EQ(sweep_table(), whole);
    }



    TEST_F(Sweep, ProcessesShareItWithTheSameResult)
    {
      if (std::system("command -v mpirun > /dev/null") != 0)
        GTEST_SKIP() << "there is no mpirun";
      const std::string scene =
        write_scene(on_one_mesh +
                    swept("set Entry 1 = Impactor/Velocity\n"
                          "set Values 1 = 1:2:9, -1\n"
                          "set Entry 2 = Plate/Thickness\n"
                          "set Values 2 = 0.008, 0.006\n"
                          "set Write histories = true"));
      // with a contact that has a memory, whose states have more to tell
      const std::string dented =
        "--set Contact/Unloading=Yang-Sun --set 'Contact/Critical "
        "indentation=1e-6' --set 'Contact/Local response=half-space' ";
      ASSERT_EQ(sweep(scene, dented), 0) << err;
      const std::string alone = sweep_table();
      const std::string history =
        text(results() / "contact_history_point_4.csv");
      const std::string mpirun =
        "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
        "mpirun --oversubscribe -n 3 ";
      ASSERT_EQ(sweep(scene, dented, mpirun), 0) << err;
      EXPECT_EQ(sweep_table(), alone);
      EXPECT_EQ(text(results() / "contact_history_point_4.csv"), history);

      // one of them tells what all find
      EXPECT_EQ(sweep(scene, "--set Plate/Density=-1", mpirun), 1);
      const std::string mistake = "Plate/Density = -1 is not allowed";
      EXPECT_NE(err.find(mistake), std::string::npos);
      EXPECT_EQ(err.find(mistake), err.rfind(mistake));
    }
  } // namespace
} // namespace PlateImpact
