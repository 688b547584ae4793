#ifndef plate_impact_exceptions_h
#define plate_impact_exceptions_h

#include <stdexcept>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// The scene or the command line is wrong: one sentence per mistake, all
  /// mistakes at once. The program ends with exit status 1.
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::vector<std::string> &mistakes)
      : std::runtime_error(join(mistakes))
    {}

  private:
    static std::string
    join(const std::vector<std::string> &mistakes)
    {
      std::string text;
      for (const std::string &mistake : mistakes)
        text += (text.empty() ? "" : "\n") + mistake;
      return text;
    }
  };

  /// A computation cannot go on: the sentence says in which step and for which
  /// quantity, and what to try. The program ends with exit status 2.
  class ComputationError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace PlateImpact

#endif
