#include "program_fixture.h"

#include <deal.II/base/multithread_info.h>

#include "plate_impact/command/commands.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>
#include <wordexp.h>

namespace PlateImpact
{
  namespace
  {
    // A child has none of the other threads that deal.II starts.
    [[maybe_unused]] const bool one_thread =
      (dealii::MultithreadInfo::set_thread_limit(1), true);
  } // namespace



  int
  execute_in_child(const std::string &arguments,
                   const std::string &out,
                   const std::string &err)
  {
    wordexp_t words;
    if (wordexp(("plate-impact " + arguments).c_str(), &words, WRDE_NOCMD) != 0)
      throw std::invalid_argument("not words of a shell: " + arguments);
    std::fflush(nullptr); // or the child prints it once more
    const pid_t child = fork();
    if (child == 0)
      {
        if (std::freopen(out.c_str(), "w", stdout) == nullptr ||
            std::freopen(err.c_str(), "w", stderr) == nullptr)
          std::abort();
        std::exit(run_command_line(words.we_wordc, words.we_wordv));
      }
    wordfree(&words);
    int status = 0;
    waitpid(child, &status, 0);
    return exit_status(status);
  }
} // namespace PlateImpact
