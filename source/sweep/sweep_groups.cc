#include "plate_impact/sweep/sweep_groups.h"

#include <algorithm>
#include <map>
#include <utility>

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
      if (section == "Impactor" || path == "Contact/Law")
        return impactor;
      return section == "Contact" || section == "Time" ? load : plate;
    }
  } // namespace



  SweepGroups::SweepGroups(const SweepPlan &plan,
                           const bool       is_adaptive,
                           const bool       is_laminate)
  {
    const bool law_changes_plate = is_laminate || plan.sweeps("Plate/Layup");
    // in the order in which their first points come
    std::map<std::string, std::size_t>                            group_of;
    std::vector<std::map<std::string, std::size_t>>               loads;
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> members;
    for (std::size_t point = 0; point < plan.n_points(); ++point)
      {
        const std::vector<std::string> values = plan.values(point);
        std::string                    plate_key, load_key;
        for (std::size_t i = 0; i < values.size(); ++i)
          {
            const std::string &path    = plan.entries()[i].path;
            const Level        changes = level(path);
            if (changes == plate ||
                (law_changes_plate && path == "Contact/Law") ||
                (is_adaptive && changes == load))
              plate_key += values[i] + '\n';
            else if (changes == load)
              load_key += values[i] + '\n';
          }
        const std::size_t group =
          group_of.emplace(plate_key, members.size()).first->second;
        if (group == members.size())
          {
            members.emplace_back();
            loads.emplace_back();
          }
        const std::size_t place =
          loads[group].emplace(load_key, loads[group].size()).first->second;
        members[group].emplace_back(place, point);
      }
    for (const auto &of_group : loads)
      n_found_loads += of_group.size();
    for (auto &group : members)
      {
        std::sort(group.begin(), group.end());
        found.emplace_back();
        for (const auto &[place, point] : group)
          found.back().push_back(point);
      }
  }



  std::vector<SweepGroups::Task>
  SweepGroups::tasks(const std::vector<bool> &to_do,
                     const std::size_t        most_points) const
  {
    std::vector<Task> tasks;
    for (std::size_t group = 0; group < found.size(); ++group)
      {
        bool is_new = true;
        for (const std::size_t point : found[group])
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
