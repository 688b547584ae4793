#ifndef plate_impact_output_terminal_h
#define plate_impact_output_terminal_h

#include <string>
#include <vector>

namespace PlateImpact
{
  enum class Emphasis
  {
    good,
    warning,
    error,
    bold
  };

  /// Whether a person looks at a stream, and what may be done for the eye then.
  class Terminal
  {
  public:
    /// @param descriptor  of the stream, as STDOUT_FILENO
    explicit Terminal(int descriptor);

    /// Whether lines can be overwritten.
    bool
    is_interactive() const;

    /// The text in colour; as it is in pipes and files, on terminals that know
    /// no colours, and where the environment variable NO_COLOR is set and not
    /// empty (no-color.org).
    std::string
    emphasized(const std::string &text, Emphasis emphasis) const;

  private:
    bool interactive, has_colours;
  };

  /// A line for each, on the standard error.
  void
  print_warnings(const std::vector<std::string> &warnings);
} // namespace PlateImpact

#endif
