#include "plate_impact/scene/scene.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/scene/scene_checker.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace PlateImpact
{
  namespace
  {
    /// Numbers between separators; none where one is no number.
    std::vector<double>
    numbers_in(const std::string &text, const char separator = ',')
    {
      std::vector<double> numbers;
      for (const std::string &item : split_list(text, separator))
        if (!any_number().read(item, numbers.emplace_back()))
          return {};
      return numbers;
    }



    /// The values of a range first:last:number.
    /// @throws InputError with what is wrong with it
    std::vector<std::string>
    values_of_range(const std::string &text)
    {
      const std::vector<double> range = numbers_in(text, ':');
      if (range.size() != 3 || range[0] == range[1] ||
          range[2] != std::floor(range[2]) || range[2] < 2. ||
          range[2] > SweepPlan::max_points)
        throw InputError(
          {fmt::format("'{}' is no range; expected first:last:number, two "
                       "numbers that differ and a whole number of values "
                       "from 2 to {}",
                       text,
                       SweepPlan::max_points)});
      // the digits of a decimal number, not the round-off of its sum
      const double             n = range[2] - 1.;
      std::vector<std::string> values;
      for (unsigned int i = 0; i <= n; ++i)
        values.push_back(
          fmt::format("{:.15g}",
                      range[0] * ((n - i) / n) + range[1] * (i / n)));
      return values;
    }



    /// Takes a list of values and ranges apart. A value is of the kind that the
    /// entry holds: allowed, or as many numbers.
    /// @throws InputError with what is wrong with it
    std::vector<std::string>
    values_in(const std::string &text, const Entry &entry)
    {
      const std::size_t n_numbers = numbers_in(entry.default_value).size();
      const char separator = text.find(';') != std::string::npos ? ';' : ',';
      std::vector<std::string> values;
      for (const std::string &item : split_list(text, separator))
        if (item.find(':') != std::string::npos && n_numbers == 1)
          for (const std::string &value : values_of_range(item))
            values.push_back(value);
        else if (entry.read(item, /*sets=*/false) ||
                 (n_numbers > 0 && numbers_in(item).size() == n_numbers))
          values.push_back(item);
        else
          throw InputError(
            {(item.empty() ? "a value is missing" :
                             "'" + item + "' is no value of " + entry.path) +
             "; expected values separated by commas, or by semicolons where "
             "they have commas themselves, each: " +
             entry.allowed});
      return values;
    }



    /// Adds an entry with its values to a plan, or a mistake to the reader's.
    void
    read_entry(SweepPlan &plan, const std::string &number, SceneReader &reader)
    {
      const Entry &entry      = reader.entries.at("Sweep/Entry " + number),
                  &list       = reader.entries.at("Sweep/Values " + number);
      const std::string &path = entry.value;
      if (path.empty())
        {
          if (!list.value.empty())
            reader.refuse(list, "has no " + entry.path + " to go with");
          return;
        }
      const std::size_t slash   = path.find('/');
      const std::string section = path.substr(0, slash);
      if (slash == std::string::npos)
        return reader.refuse(entry, "is not of the form Section/Entry");
      const Entry *const swept = reader.entries.find(path);
      if (swept == nullptr)
        return reader.refuse(entry,
                             "is not allowed: " +
                               reader.unknown(section, path.substr(slash + 1)));
      if (section == "Output" || section == "Sweep" || section == "Comparison")
        return reader.refuse(entry, "is not an entry that can be swept");
      if (plan.sweeps(path))
        return reader.refuse(entry, "is swept twice");
      if (list.value.empty())
        return reader.refuse(entry,
                             "has no values; expected them in " + list.path);
      try
        {
          plan.entries.push_back(
            {path, swept->unit(), list.origin, values_in(list.value, *swept)});
        }
      catch (const InputError &mistake)
        {
          reader.refuse(list, std::string("is not allowed: ") + mistake.what());
        }
    }



    /// What an entry changes.
    enum class Level
    {
      impactor,
      load,
      plate
    };

    Level
    level(const std::string &path)
    {
      const std::string section = path.substr(0, path.find('/'));
      if (path == "Impactor/Length" || path == "Impactor/Shape")
        return Level::load;
      if (section == "Impactor" || path == "Contact/Law" ||
          path == "Plate/Yield strength" || path == "Ply/Mode II toughness")
        return Level::impactor;
      return section == "Contact" || section == "Time" ? Level::load :
                                                         Level::plate;
    }
  } // namespace



  SweepPlan::SweepPlan(SceneReader &reader)
    : is_product(!reader.parameters.sweep.is_zip)
  {
    const std::size_t n_mistakes = reader.mistakes.size();
    for (unsigned int n = 1; n <= reader.parameters.sweep.entries.size(); ++n)
      read_entry(*this, std::to_string(n), reader);
    if (reader.mistakes.size() > n_mistakes || entries.empty())
      return;
    std::vector<std::size_t> sizes;
    double                   n = 1.;
    for (const SweptEntry &entry : entries)
      {
        sizes.push_back(entry.values.size());
        n = is_product ? n * sizes.back() : sizes.front();
      }
    Entry combination = reader.entries.at("Sweep/Combination");
    if (combination.origin == "default")
      combination.origin = entries.front().origin;
    if (!is_product &&
        std::count(sizes.begin(), sizes.end(), sizes[0]) <
          static_cast<long>(sizes.size()))
      reader.refuse(
        combination,
        fmt::format("needs lists of one length; they have {} values",
                    fmt::join(sizes, " and ")));
    else if (n > max_points)
      reader.refuse(combination,
                    fmt::format("makes {:.0f} points, {}; expected at most {}",
                                n,
                                fmt::join(sizes, is_product ? " x " : " and "),
                                max_points));
    else
      n_points = static_cast<std::size_t>(n);
  }



  SweepGroups::SweepGroups(const SweepPlan &plan, const Parameters &parameters)
  {
    const bool is_adaptive = plan.may_adapt(parameters),
               law_changes_plate =
                 parameters.plate.is_laminate() || plan.sweeps("Plate/Layup");
    // a sphere off the centre of a circle is turned onto the x axis, a cylinder
    // is not
    const bool shape_changes_plate =
      parameters.plate.outline.shape == PlateOutline::circle ||
      plan.sweeps("Plate/Outline");
    // numbers in the order in which their first points come
    std::map<std::string, std::size_t> number_of_group, number_of_load;
    std::vector<std::size_t>           load_of;
    for (std::size_t point = 0; point < plan.n_points; ++point)
      {
        const std::vector<std::string> values = plan.values(point);
        std::string                    plate_key, load_key;
        for (std::size_t i = 0; i < values.size(); ++i)
          {
            const std::string &path    = plan.entries[i].path;
            const Level        changes = level(path);
            if (changes == Level::plate ||
                (law_changes_plate && path == "Contact/Law") ||
                (shape_changes_plate && path == "Impactor/Shape") ||
                (is_adaptive && changes == Level::load))
              plate_key += values[i] + '\n';
            else if (changes == Level::load)
              load_key += values[i] + '\n';
          }
        const auto number = [](auto &numbers, const std::string &key) {
          return numbers.emplace(key, numbers.size()).first->second;
        };
        const std::size_t group = number(number_of_group, plate_key);
        groups.resize(number_of_group.size());
        groups[group].push_back(point);
        load_of.push_back(number(number_of_load, plate_key + load_key));
      }
    n_loads = number_of_load.size();
    for (auto &group : groups)
      std::stable_sort(group.begin(), group.end(), [&](auto p, auto q) {
        return load_of[p] < load_of[q];
      });
  }



  Scene
  read_scene(const std::string                &path,
             const std::vector<std::string>   &overrides,
             const std::optional<std::string> &output)
  {
    SceneReader      reader(path, overrides, output);
    SceneChecker     checker(reader);
    const Parameters given = checker;
    checker.complete();
    const SweepPlan sweep(reader);
    reader.refuse_mistakes();
    Scene scene{printable(path),
                checker,
                reader.entries.text(/*with_meanings=*/false),
                given,
                checker.expected,
                sweep,
                {}};
    for (const Entry &entry : reader.entries.all)
      scene.inputs.push_back({entry.path, entry.text()});
    return scene;
  }



  SweepScene::SweepScene(const std::string                &path,
                         const std::vector<std::string>   &overrides,
                         const std::optional<std::string> &output)
    : reader(path, overrides, output)
    , name(printable(path))
    , plan(reader)
  {
    for (const SweptEntry &swept : plan.entries)
      {
        Entry &entry = reader.entries.at(swept.path);
        if (entry.origin == "--set")
          reader.refuse(entry, "has no meaning: the entry is swept");
        entry.origin   = swept.origin;
        entry.is_known = false;
      }
    parameters = SceneChecker(reader);
    if (reader.mistakes.empty() && plan.n_points == 0)
      reader.mistakes.push_back(
        path +
        ": nothing is swept; expected Sweep/Entry 1 and Values 1, for "
        "example Impactor/Velocity and 1, 2, 5");
    reader.refuse_mistakes();
    text = reader.entries.text(/*with_meanings=*/false);
  }



  SweepPoint
  SweepScene::point(const std::size_t index)
  {
    for (Entry &entry : reader.entries.all)
      entry.chosen.reset();
    reader.mistakes.clear();
    const std::vector<std::string> values = plan.values(index);
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        const SweptEntry &swept = plan.entries[i];
        const Entry      &entry = reader.entries.at(swept.path);
        reader.set({{entry.section(), entry.name(), values[i], swept.origin}});
      }
    reader.refuse_mistakes();

    reader.parameters.plate.file = parameters.plate.file;
    SceneChecker checker(reader);
    checker.complete();
    if (reader.mistakes.empty() && !checker.expected)
      reader.mistakes = {plan.entries.front().origin +
                         ": there is no impactor"};
    reader.refuse_mistakes();
    return {checker, *checker.expected};
  }



  void
  SweepParameters::declare_entries(Entries &all)
  {
    const auto entry = all.section("Sweep");
    for (unsigned int n = 0; n < 3; ++n)
      {
        const std::string number = std::to_string(n + 1);
        entry("Entry " + number, "", any_text("Section/Entry"), entries[n]);
        entry("Values " + number, "", any_text("a list or a range"), values[n]);
      }
    all.at("Sweep/Entry 1")
      .means("This section is read by `plate-impact sweep` only. The entry of "
             "the scene that takes the values below one after another, as "
             "Section/Entry, for example Impactor/Velocity; empty: none.");
    all.at("Sweep/Values 1")
      .means("Values separated by commas, such as 1, 2, 5, and ranges "
             "first:last:number of equidistant values, such as 0.5:5:20. "
             "Semicolons separate values that contain commas, such as side "
             "lengths.");
    entry("Combination", "product", second_of("product", "zip"), is_zip)
      .means("product: every value with every other; zip: the first values of "
             "all lists, the second ones, and so on.");
    entry("Adapt",
          "worst point",
          second_of("worst point", "each point"),
          adapts_each_point)
      .means("worst point: points that share plate and load are computed on "
             "the last mesh of the one with the shortest contact; each point: "
             "on a mesh of its own.");
    entry("Estimate error", "false", truth(), estimate_error)
      .means("Estimate the error in the energy norm of every point, which then "
             "costs as much as the stepping of a run.");
    entry("Write histories", "false", truth(), write_histories)
      .means("contact_history_point_K.csv for every row K.");
  }
} // namespace PlateImpact
