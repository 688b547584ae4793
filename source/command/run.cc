#include "plate_impact/command/run.h"

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/interrupt.h"
#include "plate_impact/base/stage_clock.h"
#include "plate_impact/output/console.h"
#include "plate_impact/output/output.h"
#include "plate_impact/output/verdict.h"

#include <new>
#include <string>
#include <vector>

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
      stage(const unsigned int cycle, const std::string &what) override
      {
        throw_if_interrupted();
        console.progress.show(cycle, what);
      }

      void
      step(const unsigned int cycle,
           const unsigned int step,
           const unsigned int n_steps) override
      {
        throw_if_interrupted();
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



    /// The impact is what counts: without them there is a warning.
    void
    add_frequencies(const unsigned int        n,
                    Cycle                    &cycle,
                    std::vector<std::string> &warnings)
    {
      StageClock clock;
      try
        {
          cycle.result.natural_frequencies = cycle.plate.natural_frequencies(n);
        }
      catch (const ComputationError &error)
        {
          warnings.push_back("there are no natural frequencies: " +
                             std::string(error.what()));
        }
      clock.charge(cycle.result.seconds.output);
    }



    void
    run(const Scene &scene, Output &output, Console &console)
    {
      console.begin(scene);
      ImpactAnalysis    analysis(scene.parameters);
      AdaptationControl control(scene.parameters.adaptivity);
      RunListener       listener(output, console);
      const Outcome     outcome = analysis.run(control, listener);
      if (scene.parameters.adaptivity.verify)
        analysis.verify();
      auto warnings = analysis.all_warnings();
      add_frequencies(scene.parameters.output.natural_frequencies,
                      analysis.last_cycle(),
                      warnings.numerical);
      const Verdict verdict = verdict_of(scene.parameters,
                                         outcome,
                                         analysis.last_cycle().result,
                                         warnings);
      output.finish(outcome, warnings.all(), verdict, analysis.last_cycle());
      console.end(outcome,
                  analysis.last_cycle().result,
                  verdict,
                  warnings.all(),
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
    catch (const Interruption &interruption)
      {
        output.write_failure(interruption.what());
        throw Interruption(std::string(interruption.what()) + ": " +
                             output.kept() +
                             "; a larger Target error or a shorter End time "
                             "takes less",
                           interruption.signal);
      }
    catch (const std::bad_alloc &)
      {
        output.write_failure("not enough memory");
        throw;
      }
  }
} // namespace PlateImpact
