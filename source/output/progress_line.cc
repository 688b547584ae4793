#include "plate_impact/output/progress_line.h"

#include "plate_impact/base/text.h"

#include <iostream>
#include <unistd.h>

namespace PlateImpact
{
  ProgressLine::ProgressLine(const bool quiet)
    : out(STDOUT_FILENO)
    , is_shown(!quiet && out.is_interactive())
  {}



  ProgressLine::~ProgressLine()
  {
    clear();
  }



  void
  ProgressLine::show(const unsigned int cycle, const std::string &stage)
  {
    if (!is_shown)
      return;
    has_text = true;
    std::cout << "\r\033[K" << column(5, "{:.0f}", cycle) << "  " << stage
              << std::flush;
  }



  void
  ProgressLine::show(const unsigned int cycle,
                     const unsigned int step,
                     const unsigned int n_steps)
  {
    if (!is_shown)
      return;
    const Clock::time_point now = Clock::now();
    if (cycle != cycle_in_progress)
      {
        cycle_in_progress  = cycle;
        begin_of_transient = last = now;
      }
    if (now - last < std::chrono::milliseconds(500))
      return;
    last                                        = now;
    has_text                                    = true;
    const std::chrono::duration<double> elapsed = now - begin_of_transient;
    std::cout << "\r\033[K" << column(5, "{:.0f}", cycle) << "  step " << step
              << " of " << n_steps << ", "
              << waiting_time(elapsed.count() * (n_steps - step) / step)
              << " left" << std::flush;
  }



  void
  ProgressLine::clear()
  {
    if (has_text)
      std::cout << "\r\033[K";
    has_text = false;
  }
} // namespace PlateImpact
