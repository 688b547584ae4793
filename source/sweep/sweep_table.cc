#include "plate_impact/sweep/sweep_table.h"

#include <deal.II/base/utilities.h>

#include "plate_impact/analysis/impact_figures.h"
#include "plate_impact/base/entries.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"

#include <cerrno>
#include <map>
#include <ostream>
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
      std::string result = "\"";
      for (const char c : text)
        result += c == '"' ? "\"\"" : std::string(1, c);
      return result + '"';
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
  } // namespace



  SweepTable::SweepTable(const ResultDirectory &directory,
                         const SweepPlan       &plan,
                         const bool             resume)
    : directory(directory)
    , plan(plan)
    , found(plan.n_points())
  {
    if (resume)
      read();
    write();
    out.open(directory / file_name, std::ios::app);
  }



  std::string
  SweepTable::header() const
  {
    std::vector<std::string> names;
    for (const SweptEntry &entry : plan.entries())
      names.push_back(entry.path);
    for (const Figure &figure : impact_figures())
      names.push_back(figure.name);
    return joined(names) + "warnings,status";
  }



  std::string
  SweepTable::line(const SweepRow &row) const
  {
    std::string text = joined(plan.values(row.point));
    for (std::size_t i = 0; i < impact_figures().size(); ++i)
      {
        if (row.failure.empty() && row.figures[i])
          text += shortest(*row.figures[i]);
        text += ',';
      }
    std::string warnings;
    for (const std::string &warning : row.warnings)
      warnings += (warnings.empty() ? "" : separator) + warning;
    return text + as_field(warnings) + ',' +
      as_field(row.failure.empty() ? "ok" : row.failure);
  }



  void
  SweepTable::read()
  {
    std::map<std::string, std::vector<std::size_t>> points;
    for (std::size_t point = 0; point < plan.n_points(); ++point)
      points[joined(plan.values(point))].push_back(point);

    std::ifstream     in(directory / file_name);
    std::string       text;
    const std::size_t n_values  = plan.entries().size(),
                      n_figures = impact_figures().size();
    // a line without its end was being written when the sweep was interrupted
    if (!std::getline(in, text) || text != header())
      return;
    while (std::getline(in, text) && !in.eof())
      {
        const std::vector<std::string> fields = split(text);
        if (fields.size() != n_values + n_figures + 2 || fields.back() != "ok")
          continue;
        SweepRow row;
        for (std::size_t i = 0; i < n_figures; ++i)
          if (const std::string &field = fields[n_values + i]; field.empty())
            row.figures.emplace_back();
          else
            any_number().read(field, row.figures.emplace_back(0.).value());
        row.warnings =
          dealii::Utilities::split_string_list(fields[n_values + n_figures],
                                               separator);
        const auto place =
          points.find(joined({fields.begin(), fields.begin() + n_values}));
        if (place != points.end())
          for (const std::size_t point : place->second)
            {
              row.point    = point;
              found[point] = row;
            }
      }
  }



  void
  SweepTable::write() const
  {
    directory.write_file(file_name, [this](std::ostream &file) {
      file << header() << '\n';
      for (const std::optional<SweepRow> &row : found)
        if (row)
          file << line(*row) << '\n';
    });
  }



  void
  SweepTable::add(const SweepRow &row)
  {
    out << line(row) << '\n' << std::flush;
    if (!out)
      throw ComputationError(
        (directory / file_name).string() +
        " cannot be written: " + std::generic_category().message(errno));
    found[row.point] = row;
  }



  void
  SweepTable::finish()
  {
    out.close();
    write();
  }



  const std::vector<std::optional<SweepRow>> &
  SweepTable::rows() const
  {
    return found;
  }
} // namespace PlateImpact
