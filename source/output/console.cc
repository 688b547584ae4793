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
  } // namespace



  std::string
  emphasized(const std::string     &text,
             const fmt::text_style &style,
             const int              stream)
  {
    return is_terminal(stream) && environment("NO_COLOR").empty() ?
      fmt::format(style, "{}", text) :
      text;
  }



  void
  print_warnings(const std::vector<std::string> &warnings)
  {
    for (const std::string &warning : warnings)
      std::cerr << emphasized("warning: ",
                              fg(fmt::terminal_color::yellow),
                              STDERR_FILENO)
                << in_ascii(printable(warning)) << std::endl;
  }



  Console::Console(const bool quiet)
    : quiet(quiet)
    // mpirun makes its processes' output a terminal where it has none itself,
    // but not their input
    , overwrites(!quiet && is_terminal(STDOUT_FILENO) && isatty(STDIN_FILENO))
  {
    std::signal(SIGPIPE, SIG_IGN);
  }



  void
  Console::print(const std::string &text)
  {
    if (!quiet)
      std::cout << (overwrites ? "\r\033[K" : "") << text << std::flush;
  }



  void
  Console::show(const std::string &what,
                const std::size_t  n_done,
                const std::size_t  n)
  {
    if (!counted.empty() && what != counted)
      {
        since_begin.restart();
        since_shown.restart();
      }
    counted = what;
    if (!overwrites || since_shown.wall_time() < 0.5)
      return;
    since_shown.restart();
    show(what + std::to_string(n_done) + " of " + std::to_string(n) + ", " +
         waiting_time(since_begin.wall_time() * (n - n_done) / n_done) +
         " left");
  }
} // namespace PlateImpact
