#include "plate_impact/output/deflection_film.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe_system.h>

#include "plate_impact/estimator/recovered_field.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Bytes of a film, a third less than it takes on the page.
    constexpr std::size_t most_bytes = 1200000;

    constexpr std::size_t min_frames = 8;

    /// With fewer the stresses are left out, so that the deflection has more.
    constexpr std::size_t min_frames_of_stresses = 16;



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



    /// Deflections at points of all cells in some states, one column each. [m]
    Eigen::MatrixXf
    deflections(const PlateDiscretization           &discretization,
                const std::vector<const Snapshot *> &frames,
                const std::vector<Point<2>>         &unit_points)
    {
      const FESystem<2> &element = discretization.element.finite_element;
      Eigen::MatrixXd    shapes(unit_points.size(), element.n_dofs_per_cell());
      for (std::size_t p = 0; p < unit_points.size(); ++p)
        for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
          shapes(p, i) =
            element.shape_value_component(i, unit_points[p], deflection);
      const unsigned int n_cells = discretization.mesh().n_active_cells();
      Eigen::MatrixXf    result(n_cells * unit_points.size(), frames.size());
      for (std::size_t frame = 0; frame < frames.size(); ++frame)
        for (unsigned int cell = 0; cell < n_cells; ++cell)
          {
            const Eigen::VectorXd values =
              discretization.free_unknowns()
                .cell_values(cell, frames[frame]->unknowns);
            result.col(frame).segment(cell * unit_points.size(),
                                      unit_points.size()) =
              (shapes * values).cast<float>();
          }
      return result;
    }



    /// The fields of the section in some frames, the plate at rest before them.
    Json
    stresses_on_page(const Cycle                         &cycle,
                     const std::vector<const Snapshot *> &frames,
                     const std::vector<Point<2>>         &unit_points)
    {
      const PlateDiscretization &plate    = cycle.discretization();
      const unsigned int         n_frames = frames.size();
      Eigen::MatrixXd            states(plate.n_unknowns(), n_frames);
      for (unsigned int frame = 0; frame < n_frames; ++frame)
        states.col(frame) = frames[frame]->unknowns;
      std::vector<std::vector<SectionField>> fields;
      for (const Eigen::MatrixXd &resultants :
           recovered_resultants(plate, cycle.recovery(), states, unit_points))
        fields.push_back(section_fields(plate.section(), resultants));
      Json result = Json::array();
      for (std::size_t k = 0; k < fields.front().size(); ++k)
        {
          double largest = std::numeric_limits<double>::min();
          for (const auto &frame : fields)
            largest =
              std::max(largest, frame[k].values.lpNorm<Eigen::Infinity>());
          std::vector<std::int8_t> roots(fields.front()[k].values.size(), 0);
          for (const auto &frame : fields)
            for (const double value : frame[k].values)
              roots.push_back(std::lround(
                std::copysign(127. * std::sqrt(std::abs(value) / largest),
                              value)));
          result.push_back({{"name", fields.front()[k].name},
                            {"unit", fields.front()[k].unit},
                            {"isOdd", fields.front()[k].is_odd},
                            {"largest", largest},
                            {"values", base64(roots)}});
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
    chosen_frames(const std::size_t n_frames, const std::size_t bytes_per_frame)
    {
      const std::size_t n = std::min(n_frames, most_bytes / bytes_per_frame);
      std::vector<std::size_t> chosen;
      if (n >= std::min(n_frames, min_frames))
        for (std::size_t i = 1; i <= n; ++i)
          chosen.push_back(i * n_frames / n - 1);
      return chosen;
    }
  } // namespace



  Json
  deflection_film(const Cycle &cycle)
  {
    const CycleResult          &result          = cycle.result;
    const PlateDiscretization  &discretization  = cycle.discretization();
    const std::size_t           n_cells         = result.cells;
    const unsigned int          points_per_side = n_cells > 1000 ? 2 :
               n_cells > 60                                      ? 3 :
                                                                   5;
    const std::vector<Point<2>> unit_points =
      QIterated<2>(QTrapezoid<1>(), points_per_side - 1)
        .get_points(); // row by row
    const std::size_t n_points    = n_cells * unit_points.size();
    const auto        frames_with = [&](const std::size_t n_fields) {
      return chosen_frames(result.frames.size(),
                           n_points * (2 + n_fields) + 2 * n_cells);
    };
    std::vector<std::size_t> chosen =
      frames_with(discretization.section().n_resultants() +
                  discretization.section().stress_names().size());
    const bool has_stresses =
      chosen.size() >= std::min(result.frames.size(), min_frames_of_stresses);
    if (!has_stresses)
      chosen = frames_with(0);
    if (chosen.empty() || !result.error)
      return {};

    // the first frame is the plate at rest
    std::vector<double>       times(1, 0.), forces(1, 0.), errors(1, 0.);
    std::vector<std::int16_t> deflection(n_points, 0);
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
    const Eigen::MatrixXf w = deflections(discretization, frames, unit_points);
    const double unit       = std::max(double(w.cwiseAbs().maxCoeff()) / 32767.,
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
            {"nodesPerSide", points_per_side},
            {"times", times},
            {"forces", forces},
            {"errors", errors},
            {"deflectionUnit", unit},
            {"deflections", base64(deflection)},
            {"cellErrors", base64(cell_errors)},
            {"fields",
             has_stresses ? stresses_on_page(cycle, frames, unit_points) :
                            Json::array()}};
  }
} // namespace PlateImpact
