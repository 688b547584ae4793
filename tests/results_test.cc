#include "program_fixture.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace PlateImpact
{
  namespace
  {
    /// That results are whole and nobody else's, whatever happens.
    class ResultsAreSafe : public Program
    {
    protected:
      const std::string endless =
        " --set 'Time/Time step=1e-9' --set Time/Integrator=Newmark ";
    };



    TEST_F(ResultsAreSafe, OneRunWritesToADirectory)
    {
      ASSERT_EQ(run(main_scene), 0) << err;
      const std::string before = text(results() / "scene.prm");
      const int         other = open(results().c_str(), O_RDONLY | O_DIRECTORY);
      ASSERT_EQ(flock(other, LOCK_EX), 0);
      for (const std::string command : {"run", "compare", "sweep"})
        {
          EXPECT_EQ(execute(command + " '" + main_scene + "' --output '" +
                            results().string() +
                            "' --set 'Plate/Thickness=0.004'" +
                            (command == "sweep" ?
                               " --set 'Sweep/Entry 1=Impactor/Velocity' "
                               "--set 'Sweep/Values 1=1, 2'" :
                               "")),
                    1);
          EXPECT_NE(err.find("another run writes to the output directory"),
                    std::string::npos)
            << err;
        }
      EXPECT_EQ(text(results() / "scene.prm"), before);
      close(other);
      EXPECT_EQ(run(main_scene), 0) << err;
    }



    TEST_F(ResultsAreSafe, SignalsOfBatchSystemsKeepWhatIsDone)
    {
      EXPECT_EQ(execute("run '" + main_scene + "' --output '" +
                          results().string() + "'" + endless,
                        "timeout --foreground -s TERM --preserve-status 3 "),
                143);
      EXPECT_NE(err.find("\nplate-impact: interrupted: "), std::string::npos)
        << err;
      EXPECT_EQ(summary()["outcome"], "failed: interrupted");
    }



    TEST_F(ResultsAreSafe, SignalsBeforeTheFirstResultLeaveThoseOfBefore)
    {
      ASSERT_EQ(run(main_scene), 0) << err;
      const std::string before = text(results() / "summary.json");
      // the signal comes while the program waits for the text of its scene
      const std::string scene = (directory / "pipe.prm").string();
      ASSERT_EQ(mkfifo(scene.c_str(), 0600), 0);
      std::ofstream(directory / "script")
        << "'" << PROGRAM << "' run '" << scene << "' --output '"
        << results().string() << "' &\nexec 3> '" << scene
        << "'\nkill -TERM $!\ncat '" << main_scene
        << "' >&3\nexec 3>&-\nwait $!\n";
      const int status =
        std::system(("sh '" + (directory / "script").string() + "' > '" +
                     (directory / "out").string() + "' 2>&1")
                      .c_str());
      ASSERT_TRUE(WIFEXITED(status));
      EXPECT_EQ(WEXITSTATUS(status), 143) << text(directory / "out");
      EXPECT_EQ(text(results() / "summary.json"), before);
    }



    TEST_F(ResultsAreSafe, FullDisksAreTold)
    {
      // blocks of 512 bytes in the shell of POSIX, of 1024 in others
      ASSERT_EQ(execute("run '" + main_scene + "' --output '" +
                          results().string() + "'",
                        "ulimit -f 8; "),
                2);
      EXPECT_NE(err.find("cannot be written: File too large"),
                std::string::npos)
        << err;
      for (const auto &entry : fs::directory_iterator(results()))
        EXPECT_NE(entry.path().extension(), ".incomplete");
    }



    TEST_F(ResultsAreSafe, NamesCarryNoCodes)
    {
      const fs::path scene = directory / "two\nlines \033[31m.prm";
      fs::copy(main_scene, scene);
      ASSERT_EQ(run(scene.string()), 0) << err;
      const std::string all = text(results() / "scene.prm");
      for (const std::string &printed : {all, out, err})
        {
          EXPECT_EQ(printed.find('\033'), std::string::npos);
        }
      EXPECT_NE(all.find("two?lines ?[31m.prm\n"), std::string::npos) << all;
      fs::copy(results() / "scene.prm", directory / "again.prm");
      EXPECT_EQ(run((directory / "again.prm").string()), 0) << err;

      fs::rename(scene, directory / "\033[31m.prm");
      EXPECT_EQ(run(scene.string()), 1);
      EXPECT_EQ(err.find('\033'), std::string::npos) << err;
      EXPECT_EQ(run(main_scene, "--set 'Output/Directory=a\033b'"), 1);
      EXPECT_EQ(err.find('\033'), std::string::npos) << err;
    }



    TEST_F(ResultsAreSafe, AFileIsNoDirectory)
    {
      std::ofstream(results()) << "mine";
      for (const std::string name : {"", "/within"})
        {
          EXPECT_EQ(execute("run '" + main_scene + "' --output '" +
                            results().string() + name + "'"),
                    1);
          EXPECT_NE(err.find("is a file, or within one; expected a directory"),
                    std::string::npos)
            << err;
        }
      EXPECT_EQ(text(results()), "mine");
    }
  } // namespace
} // namespace PlateImpact
