#ifndef plate_impact_base_stage_clock_h
#define plate_impact_base_stage_clock_h

#include <deal.II/base/timer.h>

namespace PlateImpact
{
  /// Charges the wall time since the last charge, or since it was made, to a
  /// stage, so that no second is charged twice.
  class StageClock
  {
  public:
    /// @param seconds  of the stage; increased [s]
    void
    charge(double &seconds)
    {
      seconds += timer.wall_time();
      timer.restart();
    }

  private:
    dealii::Timer timer;
  };
} // namespace PlateImpact

#endif
