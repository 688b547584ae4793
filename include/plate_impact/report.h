#ifndef plate_impact_report_h
#define plate_impact_report_h

#include "plate_impact/cycle_result.h"
#include "plate_impact/scene.h"

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace PlateImpact
{
  class Page;

  /// report.html: a run on one page. Takes what it shows cycle by cycle, since
  /// the meshes do not stay.
  class Report
  {
  public:
    /// @param scene  must outlive the report
    explicit Report(const Scene &scene);

    /// @param picture  the mesh as SVG
    void
    add_cycle(const CycleResult &result, const std::string &picture);

    /// @param summary  the content of summary.json
    void
    write(std::ostream &out, const nlohmann::ordered_json &summary) const;

  private:
    /// Steps of a history that plots show, as columns.
    struct PlottedHistory
    {
      unsigned int        cycle;
      std::vector<double> time, force, plate_displacement,
        impactor_displacement, indentation, plate_energy, contact_energy,
        impactor_energy, total_energy;
    };

    static PlottedHistory
    plotted(const CycleResult &result);

    void
    add_outcome(Page &page, const nlohmann::ordered_json &summary) const;
    void
    add_histories(Page &page) const;
    void
    add_cycles(Page &page, const nlohmann::ordered_json &cycles) const;
    void
    add_meshes(Page &page) const;
    void
    add_scene(Page &page) const;

    const Scene                &scene;
    std::vector<PlottedHistory> histories;
    std::vector<std::string>    pictures;
  };
} // namespace PlateImpact

#endif
