#include "plate_impact/marking/outside_marking.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_tools.h>

#include "plate_impact/adaptation/mesh_adaptation.h"
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/plate/plate_mesh.h"

#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <sys/wait.h>
#include <vector>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// For an answer. [s]
    constexpr unsigned int time_limit = 60;

    /// Of `timeout` (coreutils), which ends what the command has begun as well.
    constexpr int status_of_timeout = 124;

    /// By how much a cell becomes larger that is to be coarsened by one level:
    /// more than the margin that the strategy keeps.
    constexpr double size_of_coarsened = 2.9;



    /// Raw and recovered resultants at the samples of all cells, of one state.
    void
    add_samples(const Cycle &cycle, const Snapshot &state, Json &cells)
    {
      const PlateDiscretization &plate = cycle.discretization();
      const QGauss<2>            samples(2);
      const Eigen::MatrixXd      recovered =
        recovered_resultants(plate,
                             cycle.recovery(),
                             state.unknowns,
                             samples.get_points())
          .front();
      for (const auto &cell : cycle.mesh().active_cell_iterators())
        {
          const unsigned int   c   = cell->active_cell_index();
          const RowMajorMatrix raw = resultants_at(plate,
                                                   c,
                                                   plate.section.stiffness(),
                                                   plate.shape(c).at_samples,
                                                   state.unknowns);
          for (unsigned int q = 0; q < samples.size(); ++q)
            {
              const Point<2> x =
                mapping_of(cell).transform_unit_to_real_cell(cell,
                                                             samples.point(q));
              const auto own    = raw.row(q);
              const auto smooth = recovered.col(samples.size() * c + q);
              cells[c]["samples"].push_back(
                {{"point", {x[0], x[1]}},
                 {"raw", std::vector<double>(own.begin(), own.end())},
                 {"recovered",
                  std::vector<double>(smooth.begin(), smooth.end())}});
            }
        }
    }



    /// What a marking may want to know.
    Json
    described(const Cycle &cycle)
    {
      const CycleResult &result = cycle.result;
      Json vertices = Json::array(), cells = Json::array(), history;
      for (const Point<2> &vertex : cycle.mesh().get_vertices())
        vertices.push_back({vertex[0], vertex[1]});
      // on the other side of each side of a cell
      std::vector<Triangulation<2>::active_cell_iterator> neighbours;
      for (const auto &cell : cycle.mesh().active_cell_iterators())
        {
          const unsigned int c = cell->active_cell_index();
          Json               one;
          for (const unsigned int v : cell->vertex_indices())
            one["vertices"].push_back(cell->vertex_index(v));
          one["level"]      = cell->level();
          one["size"]       = cell_size(cell);
          one["neighbours"] = Json::array();
          GridTools::get_active_neighbors<Triangulation<2>>(cell, neighbours);
          for (const auto &neighbour : neighbours)
            one["neighbours"].push_back(neighbour->active_cell_index());
          one["error_ratio"] = result.error_ratios->elements[c];
          if (result.peak_force_error)
            one["peak_force_error"] = result.peak_force_error->cells[c];
          cells.push_back(one);
        }
      if (result.peak_state)
        add_samples(cycle, *result.peak_state, cells);
      for (const ContactState &state : result.history->states)
        {
          history["time"].push_back(state.time);
          history["force"].push_back(state.force);
        }
      return {{"cycle", result.cycle},
              {"discretization_error", result.error->eta},
              {"peak_force", result.history->peak().force},
              {"vertices", vertices},
              {"cells", cells},
              {"history", history}};
    }



    /// The size that each cell is to have. [m]
    std::vector<double>
    sizes_of(const Json &answer, const Cycle &cycle)
    {
      const auto refuse = [&](const std::string &why) {
        throw ComputationError(
          fmt::format("cycle {}: the answer of --marking cannot be used: {}",
                      cycle.result.cycle,
                      why));
      };
      if (!answer.is_object())
        refuse("it is no object in JSON");
      for (const auto &[key, value] : answer.items())
        if (key != "refine" && key != "coarsen" && key != "sizes")
          refuse("it has \"" + key + "\"; allowed: refine, coarsen, sizes");
      const unsigned int  n = cycle.mesh().n_active_cells();
      std::vector<double> sizes;
      if (answer.contains("sizes"))
        {
          for (const Json &size : answer["sizes"])
            {
              if (!size.is_number() || size.get<double>() <= 0.)
                refuse("\"sizes\" has " + size.dump() +
                       "; allowed: lengths above 0 m");
              sizes.push_back(size);
            }
          if (sizes.size() != n)
            refuse(fmt::format("\"sizes\" has {}, the mesh has {}",
                               sizes.size(),
                               counted(n, "cell")));
          return sizes;
        }
      for (const auto &cell : cycle.mesh().active_cell_iterators())
        sizes.push_back(cell_size(cell));
      const std::vector<double> present = sizes;
      // a cell that is in both lists is refined
      for (const std::string key : {"coarsen", "refine"})
        for (const Json &cell : answer.value(key, Json::array()))
          {
            const double c = cell.is_number() ? cell.get<double>() : -1.;
            if (c < 0. || c >= n || c != std::floor(c))
              refuse(fmt::format(
                "\"{}\" has {}; allowed: numbers of cells, from 0 to {}",
                key,
                cell.dump(),
                n - 1));
            sizes[c] = present[c] * (key == "refine" ? 0.5 : size_of_coarsened);
          }
      return sizes;
    }



    /// Within a single quotation of the shell.
    std::string
    quoted(const std::string &text)
    {
      return "'" + Utilities::replace_in_string(text, "'", "'\\''") + '\'';
    }



    /// What a command says to a file.
    std::string
    answer_to(const std::string &command, const std::string &file)
    {
      const std::string all =
        fmt::format("exec timeout --kill-after=1 {} sh -c {}",
                    time_limit,
                    quoted(command + ' ' + quoted(file)));
      FILE *const pipe = popen(all.c_str(), "r");
      if (pipe == nullptr)
        throw ComputationError("--marking cannot be run: " + command);
      std::string answer;
      char        buffer[4096];
      while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe))
        answer.append(buffer, n);
      const int status = pclose(pipe);
      const int code   = WIFEXITED(status) ? WEXITSTATUS(status) : status;
      if (code == status_of_timeout)
        throw ComputationError(fmt::format("--marking takes more than {} s: {}",
                                           time_limit,
                                           command));
      if (code != 0)
        throw ComputationError(
          fmt::format("--marking ends with status {}: {}", code, command));
      return answer;
    }
  } // namespace



  Marking
  outside_marking(const std::string &command, const ResultDirectory &directory)
  {
    if (command.empty())
      return {};
    return [command, &directory](const Cycle &cycle) {
      const std::string name =
        fmt::format("marking_cycle_{}.json", cycle.result.cycle);
      directory.write_file(name, described(cycle).dump() + '\n');
      const std::string text = answer_to(command, (directory / name).string());
      const std::vector<double> sizes =
        sizes_of(Json::parse(text, nullptr, false), cycle);
      // of the analysis, which knows the singular points of the mesh
      const AdaptivityParameters &known  = cycle.parameters.adaptivity;
      ErrorRatios                 wanted = *cycle.result.error_ratios;
      for (const auto &cell : cycle.mesh().active_cell_iterators())
        {
          const unsigned int c = cell->active_cell_index();
          wanted.elements[c]   = std::pow(cell_size(cell) / sizes[c],
                                        1. / CellSizing(cell, known).exponent);
        }
      return wanted;
    };
  }
} // namespace PlateImpact
