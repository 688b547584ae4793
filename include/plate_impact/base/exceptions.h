#pragma once

#include "plate_impact/base/text.h"

#include <algorithm>
#include <fmt/format.h>
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
    /// No file makes more than a screen of sentences; of one that quotes a long
    /// value there are beginning and end.
    static std::string
    join(const std::vector<std::string> &mistakes)
    {
      constexpr std::size_t most = 20, longest = 600;
      std::string           text;
      for (std::size_t n = 0; n < std::min(most, mistakes.size()); ++n)
        {
          std::string sentence = printable(mistakes[n]);
          if (sentence.size() > longest)
            sentence.replace(longest / 2, sentence.size() - longest, " [...] ");
          text += (n > 0 ? "\n" : "") + sentence;
        }
      if (mistakes.size() > most)
        text += fmt::format("\nand {} more mistakes", mistakes.size() - most);
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

    /// The same, with what is kept.
    Interruption
    with(const std::string &kept) const
    {
      return {std::string(what()) + ": " + kept, signal};
    }

    const int signal;
  };

  /// From here on Ctrl-C (SIGINT) and the end that a batch system asks for
  /// (SIGTERM) are wishes, which throw_if_interrupted() grants between steps,
  /// vectors and files. Those of before are forgotten. A second one ends the
  /// program at once. A file that grows beyond its limit is a failed write.
  /// @param ends_at_once  the first one does so again
  void
  await_interrupt(bool ends_at_once = false);

  /// @throws Interruption  "interrupted", after one of these signals
  void
  throw_if_interrupted();
} // namespace PlateImpact
