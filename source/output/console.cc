#include "plate_impact/output/console.h"

#include "plate_impact/base/text.h"

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string_view>

namespace PlateImpact
{
  namespace
  {
    std::string_view
    environment(const char *name)
    {
      const char *const value = std::getenv(name);
      return value != nullptr ? value : "";
    }



    /// Whether a person looks at a stream.
    bool
    is_terminal(const int stream)
    {
      return isatty(stream) != 0 && environment("TERM") != "" &&
        environment("TERM") != "dumb";
    }



    /// Of an empty line: what is there is removed.
    constexpr const char *begin_of_line = "\r\033[K";
  } // namespace



  std::string
  emphasized(const std::string &text, const Emphasis emphasis, const int stream)
  {
    if (!is_terminal(stream) || !environment("NO_COLOR").empty())
      return text;
    const char *const codes[] = {"32", "33", "31", "1"};
    return std::string("\033[") + codes[static_cast<int>(emphasis)] + 'm' +
      text + "\033[0m";
  }



  void
  print_warnings(const std::vector<std::string> &warnings)
  {
    for (const std::string &warning : warnings)
      std::cerr << emphasized("warning: ", Emphasis::warning, STDERR_FILENO)
                << in_ascii(printable(warning)) << std::endl;
  }



  Console::Console(const bool quiet)
    : quiet(quiet)
    // mpirun makes its processes' output a terminal where it has none itself,
    // but not their input
    , overwrites(!quiet && is_terminal(STDOUT_FILENO) && isatty(STDIN_FILENO))
    , begin_of_count(Clock::now())
    , last(begin_of_count)
  {
    std::signal(SIGPIPE, SIG_IGN);
  }



  void
  Console::print(const std::string &text)
  {
    if (!quiet)
      std::cout << (overwrites ? begin_of_line : "") << text << std::flush;
  }



  void
  Console::show(const std::string &stage)
  {
    if (overwrites)
      std::cout << begin_of_line << stage << std::flush;
  }



  void
  Console::show(const std::string &what,
                const std::size_t  n_done,
                const std::size_t  n)
  {
    const Clock::time_point now = Clock::now();
    if (what != counted)
      {
        if (!counted.empty())
          begin_of_count = last = now;
        counted = what;
      }
    if (!overwrites || now - last < std::chrono::milliseconds(500))
      return;
    last                                        = now;
    const std::chrono::duration<double> elapsed = now - begin_of_count;
    show(what + std::to_string(n_done) + " of " + std::to_string(n) + ", " +
         waiting_time(elapsed.count() * (n - n_done) / n_done) + " left");
  }
} // namespace PlateImpact
