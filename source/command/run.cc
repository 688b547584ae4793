#include "plate_impact/command/run.h"

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/output/console.h"
#include "plate_impact/output/output.h"

#include <new>

namespace PlateImpact
{
  namespace
  {
    /// Shows and writes what an analysis finds.
    class RunListener : public AnalysisListener
    {
    public:
      RunListener(Output &output, Console &console)
        : output(output)
        , console(console)
      {}

      void
      step(const unsigned int cycle,
           const unsigned int step,
           const unsigned int n_steps) override
      {
        console.progress.show(cycle, step, n_steps);
      }

      void
      cycle(Cycle &cycle) override
      {
        output.write_cycle(cycle);
        console.cycle(cycle.result);
      }

    private:
      Output  &output;
      Console &console;
    };



    void
    run(const Scene &scene, Output &output, Console &console)
    {
      console.begin(scene);
      ImpactAnalysis    analysis(scene.parameters);
      AdaptationControl control(scene.parameters.adaptivity);
      RunListener       listener(output, console);
      const Outcome     outcome  = analysis.run(control, listener);
      const auto        warnings = analysis.all_warnings();
      output.finish(outcome, warnings, analysis.last_cycle());
      console.end(outcome,
                  analysis.last_cycle().result,
                  warnings,
                  output.main_files());
    }
  } // namespace



  void
  run_scene(const Scene &scene, const bool quiet)
  {
    Console console(quiet);
    Output  output(scene);
    try
      {
        run(scene, output, console);
      }
    catch (const ComputationError &error)
      {
        output.write_failure(error.what());
        throw;
      }
    catch (const std::bad_alloc &)
      {
        output.write_failure("not enough memory");
        throw;
      }
  }
} // namespace PlateImpact
