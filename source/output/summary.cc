#include "plate_impact/output/summary.h"

#include <deal.II/base/utilities.h>

#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/base/text.h"
#include "plate_impact/plate/plate_section.h"

#include <sstream>

namespace PlateImpact
{
  namespace
  {
    /// The largest of all plies by their names, and those of every ply.
    void
    add_stresses(const Eigen::MatrixXd &stresses,
                 const PlateParameters &plate,
                 Json                  &cycle)
    {
      if (stresses.size() == 0)
        return;
      if (!plate.is_laminate())
        {
          cycle["max_effective_stress"] = stresses(0, 0);
          return;
        }
      const auto &names = PlateSection(plate).stress_names();
      for (std::size_t k = 0; k < names.size(); ++k)
        cycle["max_" + names[k]] = stresses.col(k).maxCoeff();
      for (Eigen::Index ply = 0; ply < stresses.rows(); ++ply)
        {
          Json of_ply;
          of_ply["ply"]   = ply + 1;
          of_ply["angle"] = plate.layup.angles[ply];
          for (std::size_t k = 0; k < names.size(); ++k)
            of_ply[names[k]] = stresses(ply, k);
          cycle["plies"].push_back(of_ply);
        }
    }



    void
    add_quantities(const CycleResult &result,
                   const Parameters  &parameters,
                   const ZenerImpact &expected,
                   Json              &cycle)
    {
      const ComputedImpact impact{parameters,
                                  expected,
                                  *result.history,
                                  result.impulse};
      for (const ImpactQuantity &quantity : impact_quantities())
        if (const auto value = quantity.value(impact))
          cycle[quantity.name] = *value;
      cycle["number_of_contacts"] = result.history->n_contacts();
      if (!parameters.impactor.is_cylinder())
        cycle["zener_peak_force"] = expected.peak.force;
    }
  } // namespace



  Json
  inputs_of(const std::string &text)
  {
    Json               inputs;
    std::istringstream lines(text);
    std::string        line, section;
    while (std::getline(lines, line))
      {
        const std::size_t begin = line.find_first_not_of(' ');
        const std::size_t equal = line.find('=');
        if (line.compare(0, 11, "subsection ") == 0)
          section = line.substr(11);
        else if (begin != std::string::npos && equal != std::string::npos &&
                 line.compare(begin, 4, "set ") == 0)
          inputs[section + '/' +
                 dealii::Utilities::trim(
                   line.substr(begin + 4, equal - begin - 4))] =
            dealii::Utilities::trim(line.substr(equal + 1));
      }
    return inputs;
  }



  Json
  summary_of(const CycleResult                &result,
             const Parameters                 &parameters,
             const std::optional<ZenerImpact> &expected)
  {
    Json cycle;
    cycle["cycle"]              = result.cycle;
    cycle["cells"]              = result.cells;
    cycle["degrees_of_freedom"] = result.degrees_of_freedom;
    cycle["min_cell_size"]      = result.min_cell_size;
    if (result.error)
      {
        cycle["discretization_error"] = result.error->eta;
        if (result.error->n_singular_cells > 0)
          {
            cycle["singular_cells"] = result.error->n_singular_cells;
            cycle["discretization_error_of_all_cells"] =
              result.error->eta_of_all_cells;
            cycle["discretization_error_of_regular_cells"] =
              result.error->eta_of_regular_cells;
          }
        cycle["max_element_error"]     = result.error_ratios->max_element();
        cycle["cells_above_limit"]     = result.cells_above_limit;
        cycle["cells_at_minimum_size"] = result.cells_at_minimum_size;
      }
    if (result.history)
      {
        const ContactHistory &history = *result.history;
        const ContactState   &peak    = history.peak();
        add_quantities(result, parameters, *expected, cycle);
        if (result.damping > 0. && peak.force > 0.)
          cycle["loss_factor_of_contact"] = result.loss_factor_of_contact();
        if (result.time_error)
          cycle["time_error"] = *result.time_error;
        if (result.peak_force_error)
          cycle["peak_force_error_estimate"] = result.peak_force_error->sum();
        if (const auto &bar = result.peak_force_bar)
          {
            cycle["peak_force_error_space"] = bar->space;
            cycle["peak_force_error_time"]  = bar->time;
            cycle["peak_force_error_bar"]   = bar->total();
          }
        if (const auto &verification = result.verification)
          cycle["verification"] = {
            {"cells", verification->cells},
            {"peak_force", verification->peak_force},
            {"relative_change", verification->peak_force / peak.force - 1.}};
        if (result.sensitivity)
          cycle["sensitivity"] = result.sensitivity->factor;
        if (result.separation_time)
          cycle["no_contact_after"] = *result.separation_time;
        cycle["plate_displacement_at_peak"] = peak.plate_displacement;
        if (result.error)
          add_stresses(result.error->max_stresses, parameters.plate, cycle);
        cycle["steps"]     = result.steps;
        cycle["end_time"]  = history.states().back().time;
        cycle["time_step"] = history.states().back().time / result.steps;
        cycle["work"]      = {{"factorizations", result.work.factorizations},
                              {"linear_solves", result.work.linear_solves},
                              {"contact_steps", result.work.contact_steps},
                              {"estimator_samples", result.work.estimator_samples},
                              {"ritz_vectors", result.work.ritz_vectors}};
      }
    if (!result.natural_frequencies.empty())
      cycle["natural_frequencies"] = result.natural_frequencies;
    const Seconds &s            = result.seconds;
    cycle["seconds"]            = {{"mesh", s.mesh},
                                   {"assembly", s.assembly},
                                   {"factorization", s.factorization},
                                   {"stepping", s.stepping},
                                   {"estimation", s.estimation},
                                   {"output", s.output},
                                   {"total", s.total()}};
    cycle["cumulative_seconds"] = result.cumulative_seconds();
    return cycle;
  }
} // namespace PlateImpact
