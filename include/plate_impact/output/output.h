#ifndef plate_impact_output_output_h
#define plate_impact_output_output_h

#include <deal.II/grid/tria.h>

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/analysis/outcome.h"
#include "plate_impact/output/report.h"
#include "plate_impact/output/result_directory.h"
#include "plate_impact/output/verdict.h"
#include "plate_impact/scene/scene.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

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
    finish(Outcome                         outcome,
           const std::vector<std::string> &warnings,
           const Verdict                  &verdict,
           Cycle                          &last);

    /// summary.json of a run that failed, with the cycles before.
    void
    write_failure(const std::string &failure);

    /// Any other file.
    /// @param write  writes its content
    void
    write_file(const std::string                         &name,
               const std::function<void(std::ostream &)> &write);

    /// Where the files are and of how many cycles, for a user whose run ends
    /// early.
    std::string
    kept() const;

    /// The files to look at first, for the user.
    std::string
    main_files() const;

  private:
    /// fields.pvd and a VTU file for every snapshot: deflection, rotations,
    /// recovered resultants, von Mises stress at the faces, xi'.
    void
    write_fields(const Cycle &cycle);
    nlohmann::ordered_json
    write_summary(const std::string              &outcome,
                  const std::vector<std::string> &warnings,
                  const Verdict                  &verdict);

    const Scene           &scene;
    const ResultDirectory  directory;
    nlohmann::ordered_json cycles = nlohmann::ordered_json::array();
    Report                 report;
  };
} // namespace PlateImpact

#endif
