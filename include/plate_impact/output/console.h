#pragma once

#include <deal.II/base/timer.h>

#include <cstddef>
#include <fmt/color.h>
#include <string>
#include <unistd.h>
#include <vector>

namespace PlateImpact
{
  /// The text in colour; as it is in pipes and files, on terminals without
  /// colours, and where NO_COLOR is set and not empty (no-color.org).
  /// @param stream  that it goes to, by its descriptor
  std::string
  emphasized(const std::string     &text,
             const fmt::text_style &style,
             int                    stream = STDOUT_FILENO);

  /// To the standard error, a line each.
  void
  print_warnings(const std::vector<std::string> &warnings);


  /// What a user sees while something is computed. A reader who closes the pipe
  /// (`| head`) does not end the computation.
  class Console
  {
  public:
    explicit Console(bool quiet);

    ~Console()
    {
      print(""); // removes what show() has left
    }

    /// A text that stays. It ends with the end of a line, since the next call
    /// begins by emptying the line that it is on.
    void
    print(const std::string &text);

    /// What is done now, until something else is shown or printed; on
    /// terminals.
    void
    show(const std::string &stage)
    {
      if (overwrites)
        print(stage);
    }

    /// The same of a count, with the time that the rest takes; twice a second
    /// at most.
    /// @param what  before the count; another one begins another count
    void
    show(const std::string &what, std::size_t n_done, std::size_t n);

  private:
    const bool    quiet, overwrites;
    std::string   counted;
    dealii::Timer since_begin, since_shown; ///< of the count
  };
} // namespace PlateImpact
