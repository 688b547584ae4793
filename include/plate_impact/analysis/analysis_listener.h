#ifndef plate_impact_analysis_analysis_listener_h
#define plate_impact_analysis_analysis_listener_h

#include <string>

namespace PlateImpact
{
  class Cycle;

  /// Who follows an analysis.
  class AnalysisListener
  {
  public:
    virtual ~AnalysisListener() = default;

    /// Before what may take long.
    /// @param what  "assembly" and the like
    virtual void
    stage(unsigned int /*cycle*/, const std::string & /*what*/)
    {}

    /// After every step of a transient.
    virtual void
    step(unsigned int /*cycle*/,
         unsigned int /*step*/,
         unsigned int /*n_steps*/)
    {}

    /// After every cycle, before its mesh is adapted.
    virtual void
    cycle(Cycle & /*cycle*/)
    {}
  };
} // namespace PlateImpact

#endif
