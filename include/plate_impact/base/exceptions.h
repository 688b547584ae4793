#ifndef plate_impact_base_exceptions_h
#define plate_impact_base_exceptions_h

#include "plate_impact/base/text.h"

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
    /// No file makes more than a screen of sentences.
    static std::string
    join(const std::vector<std::string> &mistakes)
    {
      constexpr std::size_t most = 20;
      std::string           text;
      for (std::size_t n = 0; n < mistakes.size() && n < most; ++n)
        text += (text.empty() ? "" : "\n") + shortened(printable(mistakes[n]));
      if (mistakes.size() > most)
        text +=
          "\nand " + std::to_string(mistakes.size() - most) + " more mistakes";
      return text;
    }

    /// Beginning and end of a sentence that quotes a long value.
    static std::string
    shortened(const std::string &sentence)
    {
      constexpr std::size_t most = 600;
      if (sentence.size() <= most)
        return sentence;
      return sentence.substr(0, most / 2) + " [...] " +
        sentence.substr(sentence.size() - most / 2);
    }
  };

  /// A computation cannot go on: the sentence says in which step and for which
  /// quantity, and what to try. The program ends with exit status 2.
  class ComputationError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// The user has pressed Ctrl-C, or a batch system ends the program: the
  /// sentence says what is kept and how to go on. The exit status is 128 and
  /// the number of the signal, as shells have it: 130 or 143.
  class Interruption : public std::runtime_error
  {
  public:
    Interruption(const std::string &sentence, const int signal)
      : std::runtime_error(sentence)
      , signal(signal)
    {}

    const int signal;
  };
} // namespace PlateImpact

#endif
