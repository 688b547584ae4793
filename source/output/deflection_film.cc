#include "plate_impact/output/deflection_film.h"

#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Values of a film, so that it takes less than 1.5 MB on the page.
    constexpr std::size_t max_values = 500000;
    constexpr std::size_t min_frames = 8;



    template <typename Number>
    std::string
    base64(const std::vector<Number> &values)
    {
      const auto *const bytes =
        reinterpret_cast<const unsigned char *>(values.data());
      return Utilities::encode_base64(
        std::vector<unsigned char>(bytes,
                                   bytes + sizeof(Number) * values.size()));
    }



    /// Indices of the deflection at the nodes of a cell, row by row, among its
    /// values.
    std::vector<unsigned int>
    nodal_rows(const PlateDiscretization &discretization,
               const unsigned int         nodes_per_cell)
    {
      const std::vector<unsigned int> hierarchic =
        FETools::lexicographic_to_hierarchic_numbering<2>(2);
      std::vector<unsigned int> nodes(nodes_per_cell);
      for (unsigned int i = 0; i < nodes_per_cell; ++i)
        nodes[i] = nodes_per_cell == 4 ? i : hierarchic[i];
      for (unsigned int &node : nodes)
        node =
          discretization.element().finite_element().component_to_system_index(
            0,
            node);
      return nodes;
    }



    /// Deflections of all cells in some states, one column each. [m]
    Eigen::MatrixXf
    deflections(const PlateDiscretization           &discretization,
                const std::vector<const Snapshot *> &frames,
                const unsigned int                   nodes_per_cell)
    {
      const std::vector<unsigned int> rows =
        nodal_rows(discretization, nodes_per_cell);
      const unsigned int n_cells = discretization.mesh().n_active_cells();
      Eigen::MatrixXf    result(n_cells * nodes_per_cell, frames.size());
      Eigen::MatrixXd    values;
      for (std::size_t frame = 0; frame < frames.size(); ++frame)
        for (unsigned int cell = 0; cell < n_cells; ++cell)
          {
            discretization.cell_values(cell, frames[frame]->unknowns, values);
            for (unsigned int i = 0; i < nodes_per_cell; ++i)
              result(cell * nodes_per_cell + i, frame) = values(rows[i], 0);
          }
      return result;
    }



    std::int16_t
    quantized(const double value)
    {
      return std::int16_t(std::lround(std::clamp(value, -32767., 32767.)));
    }



    /// Frames, by number, that fit on the page; none when these would be few.
    std::vector<std::size_t>
    chosen_frames(const std::size_t n_frames,
                  const std::size_t values_per_frame)
    {
      const std::size_t n = std::min(n_frames, max_values / values_per_frame);
      std::vector<std::size_t> chosen;
      if (n >= std::min(n_frames, min_frames))
        for (std::size_t i = 1; i <= n; ++i)
          chosen.push_back(i * n_frames / n - 1);
      return chosen;
    }
  } // namespace



  Json
  deflection_film(const CycleResult         &result,
                  const PlateDiscretization &discretization)
  {
    const std::size_t  n_cells        = discretization.mesh().n_active_cells();
    const unsigned int nodes_per_cell = n_cells > 1000 ? 4 : 9;
    const std::vector<std::size_t> chosen =
      chosen_frames(result.frames.size(), n_cells * (nodes_per_cell + 1));
    if (chosen.empty() || !result.error)
      return {};

    // the first frame is the plate at rest
    std::vector<double>       times(1, 0.), forces(1, 0.), errors(1, 0.);
    std::vector<std::int16_t> deflection(n_cells * nodes_per_cell, 0);
    std::vector<std::int16_t> cell_errors(
      n_cells,
      std::numeric_limits<std::int16_t>::min());
    std::vector<const Snapshot *> frames;
    std::vector<std::size_t>      sample_of_frame;
    for (const std::size_t i : chosen)
      {
        const Snapshot &frame = result.frames[i];
        // the largest force is never between two frames
        if (result.peak_state && result.peak_state->time < frame.time &&
            (frames.empty() || result.peak_state->time > frames.back()->time))
          {
            frames.push_back(&*result.peak_state);
            sample_of_frame.push_back(i);
          }
        frames.push_back(&frame);
        sample_of_frame.push_back(i);
      }
    const Eigen::MatrixXf w =
      deflections(discretization, frames, nodes_per_cell);
    const double unit = std::max(double(w.cwiseAbs().maxCoeff()) / 32767.,
                                 std::numeric_limits<double>::min());

    const auto &states  = result.history->states();
    const auto &samples = result.error->sample_times;
    for (std::size_t i = 0; i < frames.size(); ++i)
      {
        const double time = frames[i]->time;
        times.push_back(time);
        const auto is_before = [](const ContactState &state, const double t) {
          return state.time < t;
        };
        forces.push_back(
          std::lower_bound(states.begin(), states.end() - 1, time, is_before)
            ->force);
        errors.push_back(
          result.error->sample_errors[std::lower_bound(samples.begin(),
                                                       samples.end() - 1,
                                                       time) -
                                      samples.begin()]);
        for (Eigen::Index row = 0; row < w.rows(); ++row)
          deflection.push_back(quantized(w(row, i) / unit));
        for (const float error :
             result.error->kept_element_errors[sample_of_frame[i]])
          cell_errors.push_back(
            error > 0.f ?
              quantized(
                1e4 * std::log10(error / result.error_ratios->element_limit)) :
              std::numeric_limits<std::int16_t>::min());
      }
    return {{"cells", n_cells},
            {"nodesPerCell", nodes_per_cell},
            {"times", times},
            {"forces", forces},
            {"errors", errors},
            {"deflectionUnit", unit},
            {"deflections", base64(deflection)},
            {"cellErrors", base64(cell_errors)}};
  }
} // namespace PlateImpact
