// What the program prints on terminals, in pipes and in files.
#include "program_fixture.h"

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
    };

    const std::string run_on_terminal =
      "script --quiet --return --command \"'$PROGRAM' run '$SCENE' --output "
      "results --set 'Time/Time step=1e-6'\" /dev/null";



    TEST_F(ConsoleOutput, HasColoursOnTerminalsOnlyAndNoneWithNoColor)
    {
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



    TEST_F(ConsoleOutput, FitsIntoEightyColumnsAndTellsTheNumbersOfTheSummary)
    {
      ASSERT_EQ(run(main_scene, "--set 'Time/Time step=1e-6'"), 0) << err;
      std::istringstream lines(out);
      std::string        line;
      std::getline(lines, line); // the name of the scene
      while (std::getline(lines, line) && !line.empty())
        EXPECT_LE(line.size(), 80u) << line;
      std::ostringstream peak;
      peak << last_cycle()["peak_force"].get<double>() << " N at "
           << 1e6 * last_cycle()["time_of_peak_force"].get<double>() << " us";
      EXPECT_NE(out.find("Peak force  " + peak.str()), std::string::npos)
        << out;
    }
  } // namespace
} // namespace PlateImpact
