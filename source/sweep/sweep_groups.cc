#include "plate_impact/sweep/sweep_groups.h"

#include <algorithm>
#include <map>

namespace PlateImpact
{
  namespace
  {
    /// What an entry changes.
    enum Level
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
        return load;
      if (section == "Impactor" || path == "Contact/Law" ||
          path == "Plate/Yield strength" || path == "Ply/Mode II toughness")
        return impactor;
      return section == "Contact" || section == "Time" ? load : plate;
    }
  } // namespace



  SweepGroups::SweepGroups(const SweepPlan &plan, const Parameters &parameters)
  {
    const bool is_adaptive = plan.may_adapt(parameters),
               law_changes_plate =
                 parameters.plate.is_laminate() || plan.sweeps("Plate/Layup");
    // numbers in the order in which their first points come
    std::map<std::string, std::size_t> number_of_group, number_of_load;
    std::vector<std::size_t>           load_of(plan.n_points);
    for (std::size_t point = 0; point < plan.n_points; ++point)
      {
        const std::vector<std::string> values = plan.values(point);
        std::string                    plate_key, load_key;
        for (std::size_t i = 0; i < values.size(); ++i)
          {
            const std::string &path    = plan.entries[i].path;
            const Level        changes = level(path);
            if (changes == plate ||
                (law_changes_plate && path == "Contact/Law") ||
                (is_adaptive && changes == load))
              plate_key += values[i] + '\n';
            else if (changes == load)
              load_key += values[i] + '\n';
          }
        const auto [group, is_new] =
          number_of_group.emplace(plate_key, groups.size());
        if (is_new)
          groups.emplace_back();
        groups[group->second].push_back(point);
        load_of[point] =
          number_of_load.emplace(plate_key + load_key, number_of_load.size())
            .first->second;
      }
    n_loads = number_of_load.size();
    for (auto &group : groups)
      std::stable_sort(group.begin(),
                       group.end(),
                       [&load_of](const std::size_t p, const std::size_t q) {
                         return load_of[p] < load_of[q];
                       });
  }



  std::vector<SweepGroups::Task>
  SweepGroups::tasks(const std::vector<bool> &to_do,
                     const std::size_t        most_points) const
  {
    std::vector<Task> tasks;
    for (std::size_t group = 0; group < groups.size(); ++group)
      {
        bool is_new = true;
        for (const std::size_t point : groups[group])
          if (to_do[point])
            {
              if (is_new || tasks.back().points.size() == most_points)
                tasks.push_back({group, {}});
              is_new = false;
              tasks.back().points.push_back(point);
            }
      }
    return tasks;
  }
} // namespace PlateImpact
