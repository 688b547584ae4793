#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace PlateImpact
{
  namespace fs = std::filesystem;

  /// A name that no other test of this or another process has.
  inline std::string
  new_scene_path()
  {
    static unsigned int n = 0;
    return (fs::temp_directory_path() /
            ("plate-impact-" + std::to_string(getpid()) + "-" +
             std::to_string(++n) + ".prm"))
      .string();
  }

  /// @param status  of waitpid() or system()
  /// @return -1 after a signal
  inline int
  exit_status(const int status)
  {
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// Does what the program does with a command line, in a child of this
  /// process, which has its libraries linked: that takes the program half a
  /// second.
  /// @param arguments  words of a shell
  /// @param out        file of what is printed; `err` of messages
  /// @return the exit status; -1 after a signal
  int
  execute_in_child(const std::string &arguments,
                   const std::string &out,
                   const std::string &err);

  const std::string main_scene = SCENES "/sphere-on-steel-plate.prm";

  /// The program as a user runs it, in a directory of its own.
  class Program : public testing::Test
  {
  protected:
    Program()
      : directory(fs::temp_directory_path() /
                  ("plate-impact-" + std::to_string(getpid())))
    {
      fs::create_directories(directory);
    }

    ~Program() override
    {
      fs::remove_all(directory);
    }

    /// Runs the program.
    /// @param arguments  words of a shell
    /// @param prefix     of the command, such as mpirun
    /// @return its exit status
    int
    execute(const std::string &arguments, const std::string &prefix = "")
    {
      const std::string to_out = (directory / "out").string(),
                        to_err = (directory / "err").string();
      const int status         = prefix.empty() ?
                execute_in_child(arguments, to_out, to_err) :
                exit_status(std::system((prefix + "'" PROGRAM "' " + arguments +
                                 " > '" + to_out + "' 2> '" + to_err + "'")
                                  .c_str()));
      out                      = text(to_out);
      err                      = text(to_err);
      return status;
    }

    int
    run(const std::string &scene, const std::string &more = "")
    {
      const int status = execute("run '" + scene + "' --output '" +
                                 results().string() + "' " + more);
      if (status == 0)
        expect_consistent(summary());
      return status;
    }

    /// What holds for every run of every scene.
    static void
    expect_consistent(const nlohmann::json &summary)
    {
      const auto &inputs = summary["inputs"];
      const auto  input  = [&inputs](const char *path) {
        return inputs[path].get<std::string>();
      };
      const bool follows_sizes =
        input("Adaptivity/Strategy") == "hanging nodes" ||
        input("Adaptivity/Strategy") == "uniform";
      double before = 0.;
      for (const auto &cycle : summary["cycles"])
        {
          const unsigned int cells = cycle["cells"];
          EXPECT_LE(cycle.value("cells_above_limit", 0u), cells);
          EXPECT_LE(cycle.value("cells_at_minimum_size", 0u),
                    cycle.value("cells_above_limit", 0u));
          // Corners of a file may be singular, and have cells as small as they
          // need. A first mesh may be finer. Neighbours within one level of a
          // cell that is refined may be of shorter sides than it is.
          const bool is_from_file =
            input("Plate/Outline").find(".msh") != std::string::npos;
          if (follows_sizes && !is_from_file)
            {
              EXPECT_GE(
                cycle["min_cell_size"].get<double>(),
                0.5 *
                  std::min(summary["cycles"][0]["min_cell_size"].get<double>(),
                           std::stod(input("Adaptivity/Minimum cell size"))));
            }
          double seconds = 0.;
          for (const auto &[stage, value] : cycle["seconds"].items())
            {
              EXPECT_GE(value.get<double>(), 0.) << stage;
              seconds += stage == "total" ? 0. : value.get<double>();
            }
          EXPECT_NEAR(cycle["seconds"]["total"].get<double>(), seconds, 1e-6);
          EXPECT_NEAR(cycle["cumulative_seconds"].get<double>(),
                      before + seconds,
                      1e-6);
          before = cycle["cumulative_seconds"];
          if (cycle.contains("peak_force_error_bar"))
            {
              EXPECT_GE(cycle["peak_force_error_bar"].get<double>(),
                        cycle["peak_force_error_space"].get<double>());
            }
        }
      const auto &last = summary["cycles"].back();
      if (summary["outcome"] == "target reached" &&
          input("Adaptivity/Goal") == "peak force")
        {
          ASSERT_TRUE(last.contains("peak_force_error_bar"));
          EXPECT_LE(last["peak_force_error_bar"].get<double>(),
                    std::stod(input("Adaptivity/Target peak force error")));
        }
      if (summary["outcome"] == "target reached" &&
          input("Adaptivity/Goal") == "energy norm")
        {
          EXPECT_LE(last["discretization_error"].get<double>(),
                    std::stod(input("Adaptivity/Target error")));
        }
    }

    using Row = std::map<std::string, std::string>;

    int
    sweep(const std::string &scene,
          const std::string &more   = "",
          const std::string &prefix = "")
    {
      return execute("sweep '" + scene + "' --output '" + results().string() +
                       "' " + more,
                     prefix);
    }

    std::string
    sweep_table() const
    {
      return text(results() / "sweep.csv");
    }

    /// Rows of a table by the names of its columns; of values with commas only
    /// the status is expected.
    std::vector<Row>
    rows(const std::string &file = "sweep.csv") const
    {
      const auto split = [](const std::string &line) {
        std::vector<std::string> fields;
        std::istringstream       in(line);
        for (std::string field; std::getline(in, field, ',');)
          fields.push_back(field);
        return fields;
      };
      std::istringstream in(text(results() / file));
      std::string        line;
      std::getline(in, line);
      const std::vector<std::string> names = split(line);
      std::vector<Row>               rows;
      while (std::getline(in, line))
        {
          Row                            row;
          const std::vector<std::string> fields = split(line);
          for (std::size_t i = 0; i < names.size() && i < fields.size(); ++i)
            row[names[i]] = fields[i];
          rows.push_back(row);
        }
      return rows;
    }

    fs::path
    results() const
    {
      return directory / "results";
    }

    nlohmann::json
    summary() const
    {
      return nlohmann::json::parse(text(results() / "summary.json"));
    }

    nlohmann::json
    last_cycle() const
    {
      return summary()["cycles"].back();
    }

    /// Of the main scene with other entries.
    nlohmann::json
    last_with(const std::string &sets)
    {
      EXPECT_EQ(run(main_scene, sets), 0) << err;
      return last_cycle();
    }

    std::string
    write_scene(const std::string &content)
    {
      const fs::path path = directory / "scene.prm";
      std::ofstream(path) << content;
      return path.string();
    }

    static std::string
    text(const fs::path &path)
    {
      std::ifstream      in(path);
      std::ostringstream content;
      content << in.rdbuf();
      return content.str();
    }

    /// The study that a page of the results shows.
    nlohmann::json
    study_of(const std::string &page) const
    {
      const std::string html = text(results() / page),
                        begin =
                          "<script type=\"application/json\" id=\"data\">";
      const std::size_t first = html.find(begin) + begin.size();
      return nlohmann::json::parse(
        html.substr(first, html.find("</script>", first) - first));
    }

    const fs::path directory;
    std::string    out, err;
  };

  inline void
  expect_near(const nlohmann::json &value,
              const nlohmann::json &expected,
              const double          relative_tolerance)
  {
    EXPECT_NEAR(value.get<double>() / expected.get<double>(),
                1.,
                relative_tolerance);
  }


  /// Plate theory on a half-space, as the paper has it and the references of
  /// tests/reference/impact_cases.json.
  const std::string half_space =
    " --set Contact/Law=Sun --set 'Contact/Local response=half-space' ";

  /// Peak force of the main scene, ball and plate as elastic finite element
  /// models, the first of tests/reference/impact_fe_cases.json. [N]
  constexpr double elastic_peak = 1400.0;
} // namespace PlateImpact
