#include "plate_impact/scene/sweep_plan.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace PlateImpact
{
  using dealii::Utilities::split_string_list;

  namespace
  {
    bool
    is_number(const std::string &text)
    {
      static const Allowed number =
        Allowed::number_from(std::numeric_limits<double>::lowest());
      return number.match(text);
    }



    /// Whether an entry holds numbers: so many in its default, 0 for words.
    std::size_t
    count_numbers(const std::string &default_value)
    {
      const std::vector<std::string> items =
        split_string_list(default_value, ',');
      const bool all =
        !items.empty() && std::all_of(items.begin(), items.end(), is_number);
      return all ? items.size() : 0;
    }



    /// Whether a value is of the kind that an entry holds.
    bool
    is_of_kind(const std::string &value,
               const std::string &default_value,
               const Allowed     &allowed)
    {
      if (allowed.match(value))
        return true;
      const std::size_t n = count_numbers(default_value);
      return n > 0 && count_numbers(value) == n;
    }



    /// Values of a range first:last:number.
    /// @return the mistake, empty when there is none
    std::string
    append_range(const std::string &text, std::vector<std::string> &values)
    {
      const std::vector<std::string> parts    = split_string_list(text, ':');
      const std::string              expected = "'" + text +
        "' is no range; expected first:last:number, two numbers that differ "
        "and a whole number of values from 2 to " +
        std::to_string(SweepPlan::max_points);
      double first, last, number;
      if (parts.size() != 3 || text.back() == ':' ||
          !std::all_of(parts.begin(), parts.end(), is_number))
        return expected;
      convert(parts[0], first);
      convert(parts[1], last);
      convert(parts[2], number);
      if (first == last || number != std::floor(number) || number < 2. ||
          number > SweepPlan::max_points)
        return expected;
      for (std::size_t i = 0; i < number; ++i)
        {
          // the digits of a decimal number, not the round-off of its sum
          const double n = number - 1.;
          values.push_back(
            fmt::format("{:.15g}", first * ((n - i) / n) + last * (i / n)));
        }
      return {};
    }



    /// Takes a list of values and ranges apart.
    /// @return the mistake, empty when there is none
    std::string
    append_values(const std::string        &text,
                  const std::string        &path,
                  const SceneSchema        &schema,
                  std::vector<std::string> &values)
    {
      const char separator = text.find(';') != std::string::npos ? ';' : ',';
      std::vector<std::string> items = split_string_list(text, separator);
      if (text.empty() || text.back() == separator)
        items.push_back("");
      for (const std::string &item : items)
        {
          const std::string &default_value = schema.default_value(path);
          if (item.find(':') != std::string::npos &&
              count_numbers(default_value) == 1)
            {
              if (const std::string mistake = append_range(item, values);
                  !mistake.empty())
                return mistake;
            }
          else if (is_of_kind(item, default_value, schema.allowed(path)))
            values.push_back(item);
          else
            return (item.empty() ? "a value is missing" :
                                   "'" + item + "' is no value of " + path) +
              "; expected values separated by commas, or by semicolons where "
              "they have commas themselves, each: " +
              schema.allowed(path).description();
        }
      return {};
    }
  } // namespace



  SweepPlan::SweepPlan(const SceneSchema &schema, const SweepParameters &sweep)
    : is_product(sweep.combination == SweepCombination::product)
  {
    for (unsigned int n = 0; n < sweep.entries.size(); ++n)
      read_entry(n, schema, sweep);
    if (found_mistakes.empty() && !swept.empty())
      combine(schema);
  }



  void
  SweepPlan::read_entry(const unsigned int     n,
                        const SceneSchema     &schema,
                        const SweepParameters &sweep)
  {
    const std::string number = std::to_string(n + 1),
                      entry  = "Sweep/Entry " + number,
                      list = "Sweep/Values " + number, &path = sweep.entries[n],
                      &values = sweep.values[n];
    const auto refuse         = [&](const std::string &which,
                            const std::string &value,
                            const std::string &text) {
      found_mistakes.push_back(schema.origin(which) + ": " + which + " = " +
                               value + " " + text);
    };
    if (path.empty())
      {
        if (!values.empty())
          refuse(list, values, "has no " + entry + " to go with");
        return;
      }
    const std::size_t slash   = path.find('/');
    const std::string section = path.substr(0, slash);
    if (slash == std::string::npos)
      return refuse(entry, path, "is not of the form Section/Entry");
    if (!schema.has_entry(path))
      return refuse(entry,
                    path,
                    "is not allowed: " +
                      schema.unknown(
                        {section, path.substr(slash + 1), "", ""}));
    if (section == "Output" || section == "Sweep" || section == "Comparison")
      return refuse(entry, path, "is no entry of an impact");
    for (const SweptEntry &other : swept)
      if (other.path == path)
        return refuse(entry, path, "is swept twice");

    SweptEntry read{path, schema.unit(path), schema.origin(list), {}};
    if (values.empty())
      return refuse(entry, path, "has no values; expected them in " + list);
    if (const std::string mistake =
          append_values(values, path, schema, read.values);
        !mistake.empty())
      return refuse(list, values, "is not allowed: " + mistake);
    swept.push_back(read);
  }



  void
  SweepPlan::combine(const SceneSchema &schema)
  {
    double      product = 1.;
    std::string sizes;
    bool        same = true;
    for (const SweptEntry &entry : swept)
      {
        const std::size_t n = entry.values.size();
        product *= static_cast<double>(n);
        sizes += (sizes.empty() ? "" :
                    is_product  ? " x " :
                                  " and ") +
          std::to_string(n);
        same = same && n == swept.front().values.size();
      }
    const double      n = is_product ? product : swept.front().values.size();
    const std::string where = (schema.origin("Sweep/Combination") == "default" ?
                                 swept.front().origin :
                                 schema.origin("Sweep/Combination")) +
      ": Sweep/Combination = " + schema.value("Sweep/Combination") + " ";
    if (!is_product && !same)
      found_mistakes.push_back(where + "needs lists of one length; they have " +
                               sizes + " values");
    else if (n > max_points)
      found_mistakes.push_back(
        fmt::format("{}makes {:.0f} points, {}; expected at most {}",
                    where,
                    n,
                    sizes,
                    max_points));
    else
      size = static_cast<std::size_t>(n);
  }



  const std::vector<std::string> &
  SweepPlan::mistakes() const
  {
    return found_mistakes;
  }



  const std::vector<SweptEntry> &
  SweepPlan::entries() const
  {
    return swept;
  }



  bool
  SweepPlan::sweeps(const std::string &path) const
  {
    return std::any_of(swept.begin(), swept.end(), [&](const auto &entry) {
      return entry.path == path;
    });
  }



  bool
  SweepPlan::forms_product() const
  {
    return is_product;
  }



  std::size_t
  SweepPlan::n_points() const
  {
    return size;
  }



  std::vector<std::string>
  SweepPlan::values(std::size_t point) const
  {
    std::vector<std::string> result(swept.size());
    for (std::size_t i = swept.size(); i-- > 0;)
      {
        const std::vector<std::string> &values = swept[i].values;
        result[i] = values[is_product ? point % values.size() : point];
        point     = is_product ? point / values.size() : point;
      }
    return result;
  }
} // namespace PlateImpact
