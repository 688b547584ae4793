#include "plate_impact/sweep/sweep_results.h"

#include <deal.II/base/utilities.h>

#include "plate_impact/analysis/impact_quantities.h"
#include "plate_impact/base/entries.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/base/version.h"
#include "plate_impact/output/report.h"
#include "plate_impact/output/run_in_words.h"
#include "plate_impact/page/page.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <ostream>
#include <regex>
#include <system_error>

namespace PlateImpact
{
  namespace
  {
    const std::string file_name = "sweep.csv";
    const std::string separator = " | "; ///< of warnings



    /// A field of a table, in quotes where it needs them (RFC 4180).
    std::string
    as_field(const std::string &text)
    {
      if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
      return '"' + dealii::Utilities::replace_in_string(text, "\"", "\"\"") +
        '"';
    }



    std::vector<std::string>
    split(const std::string &line)
    {
      std::vector<std::string> fields(1);
      bool                     is_quoted = false;
      for (const char c : line)
        if (c == '"')
          {
            // a doubled quote within quotes closes and opens them again
            if (!is_quoted && !fields.back().empty())
              fields.back() += c;
            is_quoted = !is_quoted;
          }
        else if (c == ',' && !is_quoted)
          fields.emplace_back();
        else
          fields.back() += c;
      return fields;
    }



    std::string
    joined(const std::vector<std::string> &values)
    {
      std::string text;
      for (const std::string &value : values)
        text += as_field(value) + ',';
      return text;
    }



    std::string
    header(const SweepPlan &plan)
    {
      std::vector<std::string> names;
      for (const SweptEntry &entry : plan.entries)
        names.push_back(entry.path);
      for (const ImpactQuantity &quantity : impact_quantities)
        names.push_back(quantity.name);
      return joined(names) + "warnings,status";
    }



    std::string
    line(const SweepPlan &plan, const SweepRow &row)
    {
      const bool               is_ok  = row.failure.empty();
      std::vector<std::string> fields = plan.values(row.point);
      for (std::size_t i = 0; i < impact_quantities.size(); ++i)
        fields.push_back(is_ok && !std::isnan(row.quantities[i]) ?
                           shortest(row.quantities[i]) :
                           "");
      fields.push_back(fmt::format("{}", fmt::join(row.warnings, separator)));
      return joined(fields) + as_field(is_ok ? "ok" : row.failure);
    }



    /// A sentence without its numbers and the prefixes of their units.
    std::string
    kind_of(const std::string &sentence)
    {
      static const std::regex number("[0-9][0-9.]*(e[-+]?[0-9]+)?"),
        prefix("# (p|n|µ|m|k|M|G|T)(m|s|N|J|Pa)\\b");
      return std::regex_replace(std::regex_replace(sentence, number, "#"),
                                prefix,
                                "# $2");
    }



    /// Numbers of all quantities together, so that a page stays below some
    /// megabytes. Of very large sweeps it has the first quantities only.
    constexpr std::size_t most_page_numbers = 500000;

    /// Figures of the impacts as columns.
    Json
    quantities_on_page(const std::vector<std::optional<SweepRow>> &rows)
    {
      const std::size_t n =
        std::clamp<std::size_t>(most_page_numbers / rows.size(),
                                1,
                                impact_quantities.size());
      Json quantities = Json::array();
      for (std::size_t i = 0; i < n; ++i)
        {
          const ImpactQuantity &quantity = impact_quantities[i];
          std::vector<double>   values;
          for (const auto &row : rows)
            values.push_back(row->failure.empty() ? row->quantities[i] :
                                                    std::nan(""));
          quantities.push_back({{"name", quantity.name},
                                {"title", quantity.title},
                                {"unit", quantity.unit},
                                {"values", numbers_on_page(values)}});
        }
      return quantities;
    }
  } // namespace



  SweepTable::SweepTable(const ResultDirectory &directory,
                         const SweepPlan       &plan,
                         const bool             resume)
    : rows(plan.n_points)
    , directory(directory)
    , plan(plan)
  {
    if (resume)
      read();
    write();
    out.open(directory / file_name, std::ios::app);
  }



  void
  SweepTable::read()
  {
    std::multimap<std::string, std::size_t> points;
    for (std::size_t point = 0; point < plan.n_points; ++point)
      points.emplace(joined(plan.values(point)), point);

    std::ifstream     in(directory / file_name);
    std::string       text;
    const std::size_t n_values     = plan.entries.size(),
                      n_quantities = impact_quantities.size();
    // a line without its end was being written when the sweep was interrupted
    if (!std::getline(in, text) || text != header(plan))
      return;
    while (std::getline(in, text) && !in.eof())
      {
        const std::vector<std::string> fields = split(text);
        if (fields.size() != n_values + n_quantities + 2 ||
            fields.back() != "ok")
          continue;
        SweepRow row;
        for (std::size_t i = 0; i < n_quantities; ++i)
          {
            row.quantities.push_back(
              std::nan("")); // stays where the field is empty
            any_number().read(fields[n_values + i], row.quantities.back());
          }
        row.warnings =
          dealii::Utilities::split_string_list(fields[n_values + n_quantities],
                                               separator);
        const auto [begin, end] = points.equal_range(
          joined({fields.begin(), fields.begin() + n_values}));
        for (auto place = begin; place != end; ++place)
          {
            row.point       = place->second;
            rows[row.point] = row;
          }
      }
  }



  void
  SweepTable::write() const
  {
    directory.write_file(file_name, [this](std::ostream &file) {
      file << header(plan) << '\n';
      for (const std::optional<SweepRow> &row : rows)
        if (row)
          file << line(plan, *row) << '\n';
    });
  }



  void
  SweepTable::add(const SweepRow &row)
  {
    out << line(plan, row) << '\n' << std::flush;
    if (!out)
      throw ComputationError(
        (directory / file_name).string() +
        " cannot be written: " + std::generic_category().message(errno));
    rows[row.point] = row;
  }



  std::vector<std::string>
  sweep_warnings(const std::vector<std::optional<SweepRow>> &rows)
  {
    // by sentences without numbers: the first one, and how many points have it
    nlohmann::ordered_map<std::string, std::pair<std::string, std::size_t>>
               kinds;
    const auto count = [&](const std::string &kind, const std::string &text) {
      auto &[first, n_points] = kinds[kind];
      if (n_points++ == 0)
        first = text;
    };
    // first, and no sentence of a warning: none begins with a blank
    const std::string failed = " failed";
    for (const auto &row : rows)
      if (!row->failure.empty())
        count(failed, row->failure);
    for (const auto &row : rows)
      for (const std::string &warning : row->warnings)
        count(kind_of(warning), warning);

    std::vector<std::string> warnings;
    for (const auto &[name, kind] : kinds)
      warnings.push_back(fmt::format("{} of {} points{}; the first: {}",
                                     kind.second,
                                     rows.size(),
                                     name == failed ? failed : "",
                                     kind.first));
    return warnings;
  }



  void
  write_sweep_page(std::ostream                                &out,
                   const SweepScene                            &scene,
                   const std::vector<std::optional<SweepRow>>  &rows,
                   const std::map<std::size_t, ContactHistory> &histories,
                   const SweepWork                             &work)
  {
    const SweepPlan &plan  = scene.plan;
    Json             study = {{"study", "sweep"},
                              {"version", PLATE_IMPACT_VERSION},
                              {"text", scene.text},
                              {"isProduct", plan.is_product},
                              {"warnings", sweep_warnings(rows)},
                              {"warned", Json::array()},
                              {"histories", Json::array()},
                              {"quantities", quantities_on_page(rows)},
                              {"work",
                               {{"meshes", work.meshes},
                                {"plates", work.plates},
                                {"loads", work.loads}}}};
    for (const SweptEntry &entry : plan.entries)
      study["entries"].push_back(
        {{"path", entry.path}, {"unit", entry.unit}, {"values", entry.values}});
    for (const auto &row : rows)
      {
        study["statuses"].push_back(row->failure.empty() ? "ok" : row->failure);
        if (!row->warnings.empty())
          study["warned"].push_back(row->point);
      }
    for (const auto &[point, history] : histories)
      {
        study["histories"].push_back(history_on_page(history));
        study["histories"].back()["point"] = point;
      }
    study["words"].push_back("The scene, except for the swept entries: " +
                             scene_in_words(scene.parameters));
    if (scene.plan.may_adapt(scene.parameters))
      study["words"].push_back(
        scene.parameters.sweep.adapts_each_point ?
          "Every point has a mesh of its own." :
          "The points of a plate share the mesh that was adapted for the one "
          "with the shortest contact.");
    write_page(
      out,
      {scene.name,
       std::to_string(rows.size()) + " impacts: " + plan.names() +
         (plan.entries.size() > 1 && !plan.is_product ? ", paired up" : ""),
       "sweep.csv has the peak force and other quantities of all points."},
      study);
  }
} // namespace PlateImpact
