#include "plate_impact/output/terminal.h"

#include "plate_impact/base/text.h"

#include <cstdlib>
#include <iostream>
#include <string_view>
#include <unistd.h>

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
  } // namespace



  Terminal::Terminal(const int descriptor)
    : interactive(isatty(descriptor) != 0 && environment("TERM") != "" &&
                  environment("TERM") != "dumb")
    , has_colours(interactive && environment("NO_COLOR").empty())
  {}



  bool
  Terminal::is_interactive() const
  {
    return interactive;
  }



  std::string
  Terminal::emphasized(const std::string &text, const Emphasis emphasis) const
  {
    if (!has_colours)
      return text;
    const char *const codes[] = {"32", "33", "31", "1"};
    return std::string("\033[") + codes[static_cast<int>(emphasis)] + 'm' +
      text + "\033[0m";
  }



  void
  print_warnings(const std::vector<std::string> &warnings)
  {
    const Terminal err(STDERR_FILENO);
    for (const std::string &warning : warnings)
      std::cerr << err.emphasized("warning: ", Emphasis::warning)
                << in_ascii(printable(warning)) << std::endl;
  }
} // namespace PlateImpact
