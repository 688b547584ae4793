#include "plate_impact/command/run.h"

#include "plate_impact/analysis/impact_analysis.h"
#include "plate_impact/analysis/reliability.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/output/console.h"
#include "plate_impact/output/output.h"

#include <new>

namespace PlateImpact
{
  namespace
  {
    void
    run_cycles(const Scene &scene, Output &output, Console &console)
    {
      ImpactAnalysis analysis(scene.parameters,
                              [&console](const auto cycle,
                                         const auto step,
                                         const auto n_steps) {
                                console.progress.show(cycle, step, n_steps);
                              });
      console.begin(scene);
      while (true)
        {
          CycleResult result = analysis.compute_cycle();
          output.write_cycle(result, analysis.model(), analysis.estimator());
          std::optional<std::string> end = analysis.outcome(result);
          if (!end)
            end =
              analysis.adapt(result, scene.parameters.adaptivity.target_error);
          console.cycle(result);
          if (!end)
            continue;

          if (!result.snapshots.empty())
            output.write_fields(result,
                                analysis.model(),
                                *analysis.estimator());
          std::vector<std::string> warnings;
          if (result.history)
            warnings = reliability_warnings(scene.parameters,
                                            analysis.mesh(),
                                            analysis.model().section(),
                                            *analysis.contact_law(),
                                            result);
          warnings.insert(warnings.end(),
                          analysis.warnings().begin(),
                          analysis.warnings().end());
          output.finish(*end, warnings, result, analysis.model());
          console.end(*end, result, warnings, output.main_files());
          return;
        }
    }
  } // namespace



  void
  run_scene(const Scene &scene, const bool quiet)
  {
    Console console(quiet);
    Output  output(scene);
    try
      {
        run_cycles(scene, output, console);
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
