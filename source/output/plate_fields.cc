#include <deal.II/base/data_out_base.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe_system.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/estimator/stress_recovery.h"
#include "plate_impact/output/report.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// A component of the displacements at points of all cells, a row per point
    /// and a column per cell.
    Eigen::MatrixXd
    displacements(const PlateDiscretization   &plate,
                  const Eigen::VectorXd       &unknowns,
                  const unsigned int           component,
                  const std::vector<Point<2>> &unit_points)
    {
      const FESystem<2> &element = plate.element.finite_element;
      Eigen::MatrixXd    shapes(unit_points.size(), element.n_dofs_per_cell());
      for (std::size_t p = 0; p < unit_points.size(); ++p)
        for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
          shapes(p, i) =
            element.shape_value_component(i, unit_points[p], component);
      return shapes * plate.values_of_cells(unknowns);
    }



    /// What a VTU file shows of a state at three by three points of all cells,
    /// and after that the places of these points. The values of a cell are its
    /// own: what is recovered may differ from cell to cell at hanging nodes.
    std::vector<SectionField>
    fields_in_file(const Cycle &cycle, const Eigen::VectorXd &unknowns)
    {
      const PlateDiscretization  &plate = cycle.discretization();
      const std::vector<Point<2>> unit_points =
        QIterated<2>(QTrapezoid<1>(), 2).get_points();
      std::vector<SectionField> fields;
      const auto                add = [&fields](const char            *name,
                                 const bool             is_odd_in_x,
                                 const bool             is_odd_in_y,
                                 const Eigen::MatrixXd &values) {
        fields.push_back(
          {"", "", name, {{is_odd_in_x, is_odd_in_y}}, values.reshaped()});
      };
      const char *const names[] = {"deflection",
                                   "rotation_x",
                                   "rotation_y",
                                   "displacement_x",
                                   "displacement_y"};
      for (unsigned int k = 0; k < plate.element.finite_element.n_components();
           ++k)
        add(names[k],
            k == 1 || k == 3,
            k == 2 || k == 4,
            displacements(plate, unknowns, k, unit_points));
      for (const SectionField &field :
           section_fields(plate.section,
                          recovered_resultants(plate,
                                               cycle.recovery(),
                                               unknowns,
                                               unit_points)
                            .front()))
        fields.push_back(field);
      const std::vector<double> errors = cycle.result.element_errors();
      Eigen::MatrixXd           x(unit_points.size(), errors.size()), y(x);
      for (const auto &cell : cycle.mesh().active_cell_iterators())
        for (std::size_t p = 0; p < unit_points.size(); ++p)
          {
            const Point<2> place =
              mapping_of(cell).transform_unit_to_real_cell(cell,
                                                           unit_points[p]);
            x(p, cell->active_cell_index()) = place[0];
            y(p, cell->active_cell_index()) = place[1];
          }
      add("element_error",
          false,
          false,
          Eigen::RowVectorXd::Map(errors.data(), errors.size())
            .replicate(unit_points.size(), 1));
      add("x", true, false, x);
      add("y", false, true, y);
      return fields;
    }



    /// Fields at three by three points of all cells and of their mirror images
    /// in planes of symmetry, as DataOutBase has them: the last two are places.
    std::vector<DataOutBase::Patch<2, 2>>
    patches_of(const Cycle &cycle, const std::vector<SectionField> &fields)
    {
      const auto geometry = geometry_of(cycle.parameters.plate);
      std::vector<DataOutBase::Patch<2, 2>> patches;
      for (const bool in_y : {false, true})
        for (const bool in_x : {false, true})
          for (unsigned int cell = 0; cell < cycle.result.cells; ++cell)
            {
              if ((in_x && !geometry.is_symmetric[0]) ||
                  (in_y && !geometry.is_symmetric[1]))
                continue;
              DataOutBase::Patch<2, 2> patch;
              patch.patch_index          = patches.size();
              patch.n_subdivisions       = 2;
              patch.reference_cell       = ReferenceCells::Quadrilateral;
              patch.points_are_available = true;
              patch.data.reinit(fields.size(), 9);
              for (unsigned int k = 0; k < fields.size(); ++k)
                {
                  const auto &[of_x, of_y] = fields[k].is_odd;
                  const double sign =
                    (in_x && of_x) != (in_y && of_y) ? -1. : 1.;
                  // the numbers of points turn round along a mirrored axis
                  for (unsigned int j = 0; j < 3; ++j)
                    for (unsigned int i = 0; i < 3; ++i)
                      patch.data(k, 3 * j + i) = sign *
                        fields[k].values[9 * cell + 3 * (in_y ? 2 - j : j) +
                                         (in_x ? 2 - i : i)];
                }
              patches.push_back(patch);
            }
      return patches;
    }



    /// Values rounded to numbers of a kind, column after column.
    template <typename Number>
    std::string
    base64(const Eigen::ArrayXXd &values)
    {
      const Eigen::Array<Number, Eigen::Dynamic, Eigen::Dynamic> numbers =
        values.round().template cast<Number>();
      const auto *const bytes =
        reinterpret_cast<const unsigned char *>(numbers.data());
      return Utilities::encode_base64(
        {bytes, bytes + sizeof(Number) * numbers.size()});
    }



    /// The fields of the section in some states, a column each.
    Json
    stresses_on_page(const Cycle                 &cycle,
                     const Eigen::MatrixXd       &states,
                     const std::vector<Point<2>> &unit_points)
    {
      const PlateDiscretization             &plate = cycle.discretization();
      std::vector<std::vector<SectionField>> fields;
      for (const Eigen::MatrixXd &resultants :
           recovered_resultants(plate, cycle.recovery(), states, unit_points))
        fields.push_back(section_fields(plate.section, resultants));
      Json result = Json::array();
      for (std::size_t k = 0; k < fields.front().size(); ++k)
        {
          const SectionField &first = fields.front()[k];
          Eigen::ArrayXXd     values(first.values.size(), states.cols());
          for (std::size_t i = 0; i < fields.size(); ++i)
            values.col(i) = fields[i][k].values;
          const double largest = std::max(values.abs().maxCoeff(),
                                          std::numeric_limits<double>::min());
          result.push_back(
            {{"name", first.name},
             {"unit", first.unit},
             {"isOdd", first.is_odd},
             {"largest", largest},
             {"values",
              base64<std::int8_t>(127. * values.sign() *
                                  (values.abs() / largest).sqrt())}});
        }
      return result;
    }



    /// So many frames, evenly, and that of the largest force, which is never
    /// between two; with the samples of the estimator that they are next to.
    std::vector<std::pair<const Snapshot *, std::size_t>>
    chosen_frames(const Observation &result, const std::size_t n)
    {
      const auto &peak = result.peak_state;
      std::vector<std::pair<const Snapshot *, std::size_t>> chosen;
      const auto                                            is_next = [&] {
        return peak &&
          (chosen.empty() || peak->time > chosen.back().first->time);
      };
      for (std::size_t i = 1; i <= n; ++i)
        {
          const std::size_t sample = i * result.frames.size() / n - 1;
          const Snapshot   &frame  = result.frames[sample];
          if (is_next() && peak->time < frame.time)
            chosen.emplace_back(&*peak, sample);
          chosen.emplace_back(&frame, sample);
        }
      // where the steps end before the next frame
      if (is_next())
        chosen.emplace_back(&*peak, result.frames.size() - 1);
      return chosen;
    }
  } // namespace



  void
  write_fields(const ResultDirectory &directory, const Cycle &cycle)
  {
    std::vector<std::pair<double, std::string>> record;
    for (const Snapshot &snapshot : cycle.result.snapshots)
      {
        const std::vector<SectionField> fields =
          fields_in_file(cycle, snapshot.unknowns);
        std::vector<std::string> names;
        for (const SectionField &field : fields)
          {
            // a VTU file holds floats; false for what is not a number, too
            if (!(field.values.array().abs() <
                  std::numeric_limits<float>::max())
                   .all())
              throw ComputationError(
                "the fields at t = " + number(snapshot.time, "s") +
                " contain values that a VTU file cannot hold");
            names.push_back(field.name_in_file);
          }
        names.resize(names.size() - 2);
        record.push_back(
          {snapshot.time, "fields_" + std::to_string(record.size()) + ".vtu"});
        directory.write_file(record.back().second, [&](std::ostream &out) {
          DataOutBase::write_vtu(patches_of(cycle, fields), names, {}, {}, out);
        });
      }
    directory.write_file("fields.pvd", [&](std::ostream &out) {
      DataOutBase::write_pvd_record(out, record);
    });
  }



  Json
  deflection_film(const Cycle &cycle)
  {
    const CycleResult          &result          = cycle.result;
    const PlateDiscretization  &plate           = cycle.discretization();
    const std::size_t           n_cells         = result.cells;
    const unsigned int          points_per_side = n_cells > 1000 ? 2 :
               n_cells > 60                                      ? 3 :
                                                                   5;
    const std::vector<Point<2>> unit_points =
      QIterated<2>(QTrapezoid<1>(), points_per_side - 1).get_points();
    const std::size_t     n_points   = n_cells * unit_points.size();
    const std::size_t     n_frames   = result.frames.size();
    constexpr std::size_t most_bytes = 1200000; // a third more on the page
    const auto            n_that_fit = [&](const std::size_t n_fields) {
      return std::min(n_frames,
                      most_bytes / (n_points * (2 + n_fields) + 2 * n_cells));
    };
    std::size_t n = n_that_fit(plate.section.n_resultants() +
                               plate.section.stress_names().size());
    // few frames have none, so that there are more of the deflection
    const bool has_stresses = n >= std::min<std::size_t>(n_frames, 16);
    if (!has_stresses)
      n = n_that_fit(0);
    if (n == 0 || n < std::min<std::size_t>(n_frames, 8) || !result.error)
      return {};

    const auto frames = chosen_frames(result, n);
    // the first frame is the plate at rest
    const auto         &history = result.history->states;
    const auto         &samples = result.error->sample_times;
    std::vector<double> times(1, 0.), forces(1, 0.), errors(1, 0.);
    Eigen::MatrixXd     states =
      Eigen::MatrixXd::Zero(plate.n_unknowns(), frames.size() + 1);
    Eigen::ArrayXXd w = Eigen::ArrayXXd::Zero(n_points, states.cols());
    Eigen::ArrayXXd xi =
      Eigen::ArrayXXd::Constant(n_cells,
                                states.cols(),
                                std::numeric_limits<std::int16_t>::min());
    for (const auto &[frame, sample_of_frame] : frames)
      {
        const double time = frame->time;
        const auto   state =
          std::partition_point(history.begin(),
                               history.end() - 1,
                               [=](auto &s) { return s.time < time; });
        const auto sample =
          std::lower_bound(samples.begin(), samples.end() - 1, time);
        const Eigen::Index i = times.size();
        times.push_back(time);
        forces.push_back(state->force);
        errors.push_back(result.error->sample_errors[sample - samples.begin()]);
        states.col(i) = frame->unknowns;
        w.col(i) =
          displacements(plate, frame->unknowns, deflection, unit_points)
            .reshaped();
        const Eigen::ArrayXd ratios =
          result.error->kept_element_errors[sample_of_frame]
            .array()
            .cast<double>() /
          result.error_ratios->element_limit;
        xi.col(i) =
          (ratios > 0.)
            .select((1e4 * ratios.log10()).max(-32767.).min(32767.), xi.col(i));
      }
    const double unit =
      std::max(w.abs().maxCoeff() / 32767., std::numeric_limits<double>::min());
    return {{"cells", n_cells},
            {"nodesPerSide", points_per_side},
            {"times", times},
            {"forces", forces},
            {"errors", errors},
            {"deflectionUnit", unit},
            {"deflections", base64<std::int16_t>(w / unit)},
            {"cellErrors", base64<std::int16_t>(xi)},
            {"fields",
             has_stresses ? stresses_on_page(cycle, states, unit_points) :
                            Json::array()}};
  }
} // namespace PlateImpact
