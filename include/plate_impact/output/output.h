#pragma once

#include "plate_impact/base/text.h"
#include "plate_impact/output/report.h"

#include <string>

namespace PlateImpact
{
  /// The only writer of the results of a run.
  class Output
  {
  public:
    /// Clears the directory and writes scene.prm.
    /// @param scene  must outlive this object
    /// @throws ComputationError, as all members, when a file cannot be written
    explicit Output(const Scene &scene);

    /// contact_history.csv, the one of the cycle before becoming
    /// contact_history_cycle_K.csv; element_errors_cycle_K.csv;
    /// mesh_cycle_K.svg.
    void
    write_cycle(Cycle &cycle);

    /// The fields of the last cycle, where the scene asks for them,
    /// summary.json and report.html.
    void
    finish(Outcome outcome, const Verdict &verdict, Cycle &last);

    /// summary.json of a run that failed, with the cycles before.
    void
    write_failure(const std::string &failure);

    /// Where the files are and of how many cycles, for a user whose run ends
    /// early.
    std::string
    kept() const
    {
      return (directory / "").string() + " has " +
        counted(cycles.size(), "cycle");
    }

    const ResultDirectory directory;

  private:
    Json
    write_summary(const std::string &outcome, const Verdict &verdict);

    const Scene &scene;
    Json         cycles = Json::array();
    Json         study  = {{"study", "run"}}; ///< for the report
  };
} // namespace PlateImpact
