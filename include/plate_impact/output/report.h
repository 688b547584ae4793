#ifndef plate_impact_output_report_h
#define plate_impact_output_report_h

#include "plate_impact/analysis/cycle.h"
#include "plate_impact/page/page.h"
#include "plate_impact/scene/scene.h"

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// report.html: a run on one page. Takes what it shows cycle by cycle, since
  /// the meshes do not stay.
  class Report
  {
  public:
    /// @param scene  must outlive the report
    explicit Report(const Scene &scene);

    void
    add_cycle(const Cycle &cycle);

    /// @param summary  the content of summary.json
    /// @param film     deflection_film() of the last cycle
    void
    write(std::ostream                 &out,
          const nlohmann::ordered_json &summary,
          const nlohmann::ordered_json &film) const;

  private:
    /// Steps of a history that plots show, as columns.
    struct PlottedHistory
    {
      unsigned int        cycle;
      std::vector<double> time, force, plate_displacement,
        impactor_displacement, indentation, plate_energy, contact_energy,
        impactor_energy, total_energy;
    };

    /// Columns by the names of their curves.
    using Quantities = std::vector<
      std::pair<std::string, std::vector<double> PlottedHistory::*>>;

    /// What an axis shows: 0 and the quantities of one history.
    static std::pair<double, double>
    extent_of(const PlottedHistory &history, const Quantities &quantities);

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
    add_film(Page &page, const nlohmann::ordered_json &film) const;
    void
    add_scene(Page &page) const;

    /// eta(t) of a cycle.
    struct ErrorHistory
    {
      unsigned int        cycle;
      std::vector<double> time, error;
    };

    const Scene                &scene;
    std::vector<PlottedHistory> histories;
    std::vector<ErrorHistory>   error_histories;
    std::vector<MeshPicture>    meshes;
  };
} // namespace PlateImpact

#endif
