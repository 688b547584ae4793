// What the program prints on terminals, in pipes and in files.
#include "plate_impact/base/text.h"
#include "program_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace PlateImpact
{
  namespace
  {
    class ConsoleOutput : public Program
    {
    protected:
      /// Runs a command of the shell in which $PROGRAM stands for the program.
      int
      shell(const std::string &command)
      {
        std::ofstream(directory / "script") << command;
        const std::string line = "cd '" + directory.string() +
          "' && PROGRAM='" PROGRAM "' SCENE='" + main_scene +
          "' sh script > out 2> err";
        const int status = std::system(line.c_str());
        out              = text(directory / "out");
        err              = text(directory / "err");
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
      }

      bool
      has_terminal()
      {
        return shell("script --quiet --return --command true /dev/null") == 0;
      }
    };

    const std::string no_terminal =
      "script opens no terminal here: is /dev/pts mounted?";

    const std::string run_on_terminal =
      "script --quiet --return --command \"'$PROGRAM' run '$SCENE' --output "
      "results --set 'Time/Time step=1e-6'\" /dev/null";



    TEST_F(ConsoleOutput, HasColoursOnTerminalsOnlyAndNoneWithNoColor)
    {
      if (!has_terminal())
        GTEST_SKIP() << no_terminal;
      ASSERT_EQ(shell("TERM=xterm NO_COLOR= " + run_on_terminal), 0) << out;
      EXPECT_NE(out.find("\033[32mtarget reached"), std::string::npos) << out;
      ASSERT_EQ(shell("TERM=xterm NO_COLOR=1 " + run_on_terminal), 0) << out;
      EXPECT_NE(out.find("target reached"), std::string::npos) << out;
      EXPECT_EQ(out.find("\033[3"), std::string::npos) << out;
      ASSERT_EQ(shell("TERM=dumb NO_COLOR= " + run_on_terminal), 0) << out;
      EXPECT_EQ(out.find('\033'), std::string::npos) << out;
      ASSERT_EQ(run(main_scene, "--set 'Time/Time step=1e-6'"), 0) << err;
      EXPECT_EQ(out.find('\033'), std::string::npos) << out;
    }



    TEST_F(ConsoleOutput, RunSurvivesAReaderThatLeaves)
    {
      ASSERT_EQ(shell("( \"$PROGRAM\" run \"$SCENE\" --output results --set "
                      "'Time/Time step=1e-6'; echo $? > status ) | head -n 1"),
                0);
      EXPECT_EQ(text(directory / "status"), "0\n");
      EXPECT_EQ(err, "");
      EXPECT_EQ(summary()["outcome"], "target reached");
      EXPECT_EQ(shell("\"$PROGRAM\" defaults | head -n 1"), 0);
      EXPECT_EQ(err, "");
    }



    const std::string small_sweep =
      " sweep \"$SCENE\" --output results --set Adaptivity/Strategy=none "
      "--set 'Sweep/Entry 1=Impactor/Velocity' --set 'Sweep/Values 1=1:2:30' ";



    TEST_F(ConsoleOutput, SweepSurvivesAReaderThatLeaves)
    {
      // more than the reader takes before it leaves
      ASSERT_EQ(shell("( \"$PROGRAM\"" + small_sweep +
                      "; echo $? > status ) | head -n 1"),
                0);
      EXPECT_EQ(text(directory / "status"), "0\n");
      const std::string table = text(results() / "sweep.csv");
      EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 31) << table;
    }



    TEST_F(ConsoleOutput, FilesTakeNothingThatClosedStreamsDoNot)
    {
      for (const std::string command :
           {" run \"$SCENE\" --output results ", small_sweep.c_str()})
        {
          ASSERT_EQ(shell("\"$PROGRAM\"" + command), 0) << err;
          std::map<fs::path, std::string> before;
          for (const auto &entry : fs::directory_iterator(results()))
            if (entry.path().extension() == ".csv")
              before[entry.path()] = text(entry.path());
          EXPECT_FALSE(before.empty());
          ASSERT_EQ(shell("\"$PROGRAM\"" + command + "<&- >&- 2>&-"), 0);
          for (const auto &[path, content] : before)
            EXPECT_EQ(text(path), content) << path;
        }
    }



    TEST_F(ConsoleOutput, InterruptedSaysWhatIsKeptAndHowToGoOn)
    {
      // once: a second signal ends the program at once
      const std::string for_a_while =
        "timeout --foreground -s INT --preserve-status 3 ";
      EXPECT_EQ(shell(for_a_while +
                      "\"$PROGRAM\" run \"$SCENE\" --output results --set "
                      "'Time/Time step=1e-9' --set 'Time/Integrator=Newmark'"),
                130);
      EXPECT_EQ(err.find("plate-impact: stopping"), 0u) << err;
      EXPECT_NE(err.find("\nplate-impact: interrupted: results/ has "),
                std::string::npos)
        << err;
      EXPECT_NE(err.find("Target error"), std::string::npos) << err;
      EXPECT_EQ(summary()["outcome"], "failed: interrupted");
      EXPECT_EQ(summary()["verdict"]["trust"], "none");

      const std::string sweep =
        "\"$PROGRAM\" sweep \"$SCENE\" --output results --set Adaptivity/"
        "Strategy=none --set 'Sweep/Entry 1=Impactor/Velocity' --set "
        "'Sweep/Values 1=1:2:100000' --set 'Time/Integrator=Newmark' ";
      EXPECT_EQ(shell(for_a_while + sweep), 130);
      EXPECT_NE(err.find(
                  " of 100000 points are in results/sweep.csv; --resume "),
                std::string::npos)
        << err;
      const auto n_rows = [&] {
        const std::string table = text(results() / "sweep.csv");
        return std::count(table.begin(), table.end(), '\n');
      };
      const auto before = n_rows();
      // the point that was under way is none of them
      EXPECT_EQ(text(results() / "sweep.csv").find("interrupted"),
                std::string::npos);
      EXPECT_NE(err.find(" " + std::to_string(before - 1) + " of 100000"),
                std::string::npos)
        << err;
      EXPECT_EQ(shell(for_a_while + sweep + "--resume"), 130);
      EXPECT_GT(n_rows(), before);
    }



    TEST_F(ConsoleOutput, LargeSweepTellsTheTimeThatIsLeft)
    {
      if (!has_terminal())
        GTEST_SKIP() << no_terminal;
      const std::string command =
        "script --quiet --return --command \"'$PROGRAM' sweep '$SCENE' --output "
        "results --set Adaptivity/Strategy=none --set 'Sweep/Entry "
        "1=Impactor/Velocity' --set 'Sweep/Values 1=1:2:6000'\" /dev/null";
      ASSERT_EQ(shell("TERM=xterm " + command), 0) << out;
      EXPECT_NE(out.find(" of 6000, "), std::string::npos) << out;
      EXPECT_NE(out.find(" left"), std::string::npos) << out;
    }



    TEST_F(ConsoleOutput, FitsIntoEightyColumnsAndTellsTheNumbersOfTheSummary)
    {
      ASSERT_EQ(run(main_scene, "--set 'Time/Time step=1e-6'"), 0) << err;
      std::istringstream lines(out);
      std::string        line;
      std::getline(lines, line); // the name of the scene
      while (std::getline(lines, line) && !line.empty())
        EXPECT_LE(line.size(), 80u) << line;
      const double force = last_cycle()["peak_force"],
                   error =
                     force * last_cycle()["peak_force_error_bar"].get<double>();
      // to the digits that the error leaves
      EXPECT_NE(out.find("Peak force  " +
                         in_ascii(with_error(force, error, "N")) +
                         " (mesh, step) +- 5 N (model, from comparisons)\n"),
                std::string::npos)
        << out;
    }
  } // namespace
} // namespace PlateImpact
