#include "plate_impact/base/interrupt.h"

#include "plate_impact/base/exceptions.h"

#include <csignal>
#include <unistd.h>

namespace PlateImpact
{
  namespace
  {
    volatile std::sig_atomic_t is_interrupted = 0;

    void
    note_interrupt(int)
    {
      is_interrupted = 1;
      std::signal(SIGINT, SIG_DFL);
      constexpr char answer[] =
        "plate-impact: stopping after this step; Ctrl-C again ends at once\n";
      if (write(STDERR_FILENO, answer, sizeof(answer) - 1) < 0)
        return; // nobody reads
    }
  } // namespace



  void
  await_interrupt()
  {
    // the shell makes programs in the background deaf to it
    if (std::signal(SIGINT, note_interrupt) == SIG_IGN)
      std::signal(SIGINT, SIG_IGN);
  }



  void
  throw_if_interrupted()
  {
    if (is_interrupted != 0)
      throw Interruption("interrupted");
  }
} // namespace PlateImpact
