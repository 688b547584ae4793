#ifndef plate_impact_output_progress_line_h
#define plate_impact_output_progress_line_h

#include "plate_impact/output/terminal.h"

#include <chrono>

namespace PlateImpact
{
  /// A line that is overwritten, with the time that the rest of the transient
  /// takes; on a terminal and within long transients only.
  class ProgressLine
  {
  public:
    /// @param quiet  shows nothing
    explicit ProgressLine(bool quiet);

    ~ProgressLine();

    /// What is done now, until the next call.
    void
    show(unsigned int cycle, const std::string &stage);

    void
    show(unsigned int cycle, unsigned int step, unsigned int n_steps);

    /// Before anything else is printed.
    void
    clear();

  private:
    using Clock = std::chrono::steady_clock;

    const Terminal    out;
    const bool        is_shown;
    bool              has_text          = false;
    unsigned int      cycle_in_progress = 0;
    Clock::time_point begin_of_transient, last;
  };
} // namespace PlateImpact

#endif
