#include "plate_impact/output/plate_fields.h"

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe_system.h>

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/estimator/recovered_field.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_mesh.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    /// Evenly over the reference cell, row by row.
    std::vector<Point<2>>
    points_of_cell(const unsigned int points_per_side)
    {
      return QIterated<2>(QTrapezoid<1>(), points_per_side - 1).get_points();
    }



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
      Eigen::MatrixXd values(unit_points.size(), plate.mesh().n_active_cells());
      for (unsigned int cell = 0; cell < values.cols(); ++cell)
        values.col(cell) = shapes * plate.cell_values(cell, unknowns);
      return values;
    }



    /// What a VTU file shows of a state at points of all cells, and after that
    /// the places of these points. The values of a cell are its own: what is
    /// recovered may differ from cell to cell at hanging nodes.
    std::vector<SectionField>
    fields_in_file(const Cycle                 &cycle,
                   const Eigen::VectorXd       &unknowns,
                   const std::vector<Point<2>> &unit_points)
    {
      const PlateDiscretization &plate = cycle.discretization();
      std::vector<SectionField>  fields;
      const auto                 add = [&fields](const char            *name,
                                 const bool             is_odd_in_x,
                                 const bool             is_odd_in_y,
                                 const Eigen::MatrixXd &values) {
        fields.push_back(
          {"", "", name, {{is_odd_in_x, is_odd_in_y}}, values.reshaped()});
      };
      const auto displacement = [&](const unsigned int component) {
        return displacements(plate, unknowns, component, unit_points);
      };
      add("deflection", false, false, displacement(0));
      add("rotation_x", true, false, displacement(1));
      add("rotation_y", false, true, displacement(2));
      if (plate.element.finite_element.n_components() > 3)
        {
          add("displacement_x", true, false, displacement(3));
          add("displacement_y", false, true, displacement(4));
        }
      for (const SectionField &field :
           section_fields(plate.section(),
                          recovered_resultants(plate,
                                               cycle.recovery(),
                                               unknowns,
                                               unit_points)
                            .front()))
        fields.push_back(field);
      Eigen::MatrixXd errors(unit_points.size(), cycle.result.cells), x(errors),
        y(errors);
      for (const auto &cell : cycle.mesh().active_cell_iterators())
        for (std::size_t p = 0; p < unit_points.size(); ++p)
          {
            const unsigned int c = cell->active_cell_index();
            const Point<2>     place =
              mapping_of(cell).transform_unit_to_real_cell(cell,
                                                           unit_points[p]);
            errors(p, c) = cycle.result.error_ratios->elements[c];
            x(p, c)      = place[0];
            y(p, c)      = place[1];
          }
      add("element_error", false, false, errors);
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



    /// Bytes of a film, a third less than it takes on the page.
    constexpr std::size_t most_bytes = 1200000;

    constexpr std::size_t min_frames = 8;

    /// With fewer the stresses are left out, so that the deflection has more.
    constexpr std::size_t min_frames_of_stresses = 16;



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
        std::vector<unsigned char>(bytes,
                                   bytes + sizeof(Number) * numbers.size()));
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
          const SectionField &first = fields.front()[k];
          Eigen::ArrayXXd     values =
            Eigen::ArrayXXd::Zero(first.values.size(), n_frames + 1);
          for (unsigned int frame = 0; frame < n_frames; ++frame)
            values.col(frame + 1) = fields[frame][k].values;
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



  void
  write_fields(const ResultDirectory &directory, const Cycle &cycle)
  {
    std::vector<std::pair<double, std::string>> record;
    for (const Snapshot &snapshot : cycle.result.snapshots)
      {
        const std::vector<SectionField> fields =
          fields_in_file(cycle, snapshot.unknowns, points_of_cell(3));
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
    const std::vector<Point<2>> unit_points = points_of_cell(points_per_side);
    const std::size_t           n_points    = n_cells * unit_points.size();
    const auto                  frames_with = [&](const std::size_t n_fields) {
      return chosen_frames(result.frames.size(),
                           n_points * (2 + n_fields) + 2 * n_cells);
    };
    std::vector<std::size_t> chosen = frames_with(
      plate.section().n_resultants() + plate.section().stress_names().size());
    const bool has_stresses =
      chosen.size() >= std::min(result.frames.size(), min_frames_of_stresses);
    if (!has_stresses)
      chosen = frames_with(0);
    if (chosen.empty() || !result.error)
      return {};

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
    // the first frame is the plate at rest
    const auto         &states  = result.history->states();
    const auto         &samples = result.error->sample_times;
    std::vector<double> times(1, 0.), forces(1, 0.), errors(1, 0.);
    Eigen::ArrayXXd     w = Eigen::ArrayXXd::Zero(n_points, frames.size() + 1);
    Eigen::ArrayXXd     xi =
      Eigen::ArrayXXd::Constant(n_cells,
                                frames.size() + 1,
                                std::numeric_limits<std::int16_t>::min());
    for (std::size_t i = 0; i < frames.size(); ++i)
      {
        const double time = frames[i]->time;
        const auto   state =
          std::partition_point(states.begin(), states.end() - 1, [=](auto &s) {
            return s.time < time;
          });
        const auto sample =
          std::lower_bound(samples.begin(), samples.end() - 1, time);
        times.push_back(time);
        forces.push_back(state->force);
        errors.push_back(result.error->sample_errors[sample - samples.begin()]);
        w.col(i + 1) =
          displacements(plate, frames[i]->unknowns, deflection, unit_points)
            .reshaped();
        const Eigen::ArrayXd ratios =
          result.error->kept_element_errors[sample_of_frame[i]]
            .array()
            .cast<double>() /
          result.error_ratios->element_limit;
        xi.col(i + 1) =
          (ratios > 0.)
            .select((1e4 * ratios.log10()).max(-32767.).min(32767.),
                    xi.col(i + 1));
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
             has_stresses ? stresses_on_page(cycle, frames, unit_points) :
                            Json::array()}};
  }
} // namespace PlateImpact
