#include "plate_impact/base/exceptions.h"

#include <csignal>
#include <cstring>
#include <unistd.h>

namespace PlateImpact
{
  namespace
  {
    volatile std::sig_atomic_t signal_received = 0;

    void
    note_signal(const int number)
    {
      signal_received = number;
      std::signal(number, SIG_DFL);
      const char *const answer = number == SIGINT ?
        "plate-impact: stopping after this step; Ctrl-C again ends at once\n" :
        "plate-impact: stopping after this step\n";
      if (write(STDERR_FILENO, answer, std::strlen(answer)) < 0)
        return; // nobody reads
    }
  } // namespace



  void
  await_interrupt(const bool ends_at_once)
  {
    signal_received = 0;
    // the shell makes programs in the background deaf to Ctrl-C
    for (const int number : {SIGINT, SIGTERM})
      if (std::signal(number, ends_at_once ? SIG_DFL : note_signal) == SIG_IGN)
        std::signal(number, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
  }



  void
  throw_if_interrupted()
  {
    if (signal_received != 0)
      throw Interruption("interrupted", signal_received);
  }
} // namespace PlateImpact
