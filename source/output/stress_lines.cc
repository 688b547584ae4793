#include "plate_impact/output/stress_lines.h"

#include <deal.II/base/geometry_info.h>

#include "plate_impact/estimator/recovered_field.h"
#include "plate_impact/output/section_fields.h"
#include "plate_impact/plate/plate_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int points_per_cell = 9;

    /// A straight line away from a point; distances along it are lengths.
    struct Ray
    {
      Point<2>     origin;
      Tensor<1, 2> direction;
    };

    /// Distances at which a ray enters and leaves a cell with straight edges;
    /// the second is the smaller where it does not meet the cell.
    std::pair<double, double>
    crossing(const Ray &ray, const RecoveredField::Cell &cell)
    {
      double enters = 0., leaves = std::numeric_limits<double>::max();
      const unsigned int around[] = {0, 1, 3, 2};
      for (unsigned int side = 0; side < 4; ++side)
        {
          const Point<2>     begin = cell->vertex(around[side]);
          const Tensor<1, 2> edge =
            cell->vertex(around[(side + 1) % 4]) - begin;
          // counter-clockwise: the cell is to the left of its edges
          const double inside   = cross_product_2d(edge) * (begin - ray.origin);
          const double approach = cross_product_2d(edge) * ray.direction;
          if (approach == 0. && inside < 0.)
            leaves = -1.;
          else if (approach > 0.)
            leaves = std::min(leaves, inside / approach);
          else if (approach < 0.)
            enters = std::max(enters, inside / approach);
        }
      return {enters, leaves};
    }

    /// Cells that a ray meets, by the distances at which it does.
    std::map<double, std::pair<double, RecoveredField::Cell>>
    cells_along(const Ray &ray, const Triangulation<2> &mesh)
    {
      std::map<double, std::pair<double, RecoveredField::Cell>> cells;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const auto [enters, leaves] = crossing(ray, cell);
          if (leaves - enters > 1e-4 * cell->diameter())
            cells.insert({enters, {leaves, cell}});
        }
      return cells;
    }

    Json
    values_on_page(const PlateSection &section, const Eigen::MatrixXd &points)
    {
      Json result = Json::array();
      for (const SectionField &field : section_fields(section, points))
        result.push_back(
          numbers_on_page({field.values.begin(), field.values.end()}));
      return result;
    }



    Json
    stresses_along(const Ray      &ray,
                   const Cycle    &cycle,
                   RecoveredField &field,
                   const Snapshot &state)
    {
      const PlateDiscretization &plate = cycle.discretization();
      const auto                 cells = cells_along(ray, plate.mesh());
      std::vector<double>        distances;
      const double               gap = std::numeric_limits<double>::quiet_NaN();
      const auto                 n   = cells.size() * (points_per_cell + 1);
      const auto                 m   = plate.section().n_resultants();
      Eigen::MatrixXd            raw = Eigen::MatrixXd::Constant(m, n, gap),
                      recovered      = raw;
      for (const auto &[enters, rest] : cells)
        {
          const auto &[leaves, cell] = rest;
          std::vector<Point<2>> unit_points;
          const auto            column = distances.size();
          for (unsigned int i = 0; i < points_per_cell; ++i)
            {
              distances.push_back(
                enters + (leaves - enters) * i / (points_per_cell - 1));
              unit_points.push_back(GeometryInfo<2>::project_to_unit_cell(
                mapping_of(cell).transform_real_to_unit_cell(
                  cell,
                  ray.origin + distances.back() * ray.direction)));
            }
          distances.push_back(leaves); // the gap
          const auto stiffness = plate.section().stiffness();
          const auto set       = [&](Eigen::MatrixXd      &to,
                               const RowMajorMatrix &from) {
            to.middleCols(column, points_per_cell) = from.transpose();
          };
          set(raw,
              resultants_at(plate,
                            cell->active_cell_index(),
                            stiffness,
                            plate.element().strains_at(cell, unit_points),
                            state.unknowns));
          RowMajorMatrix smooth;
          field.evaluate(cell, unit_points, smooth);
          set(recovered, smooth);
        }
      return {{"distance", numbers_on_page(distances)},
              {"raw", values_on_page(plate.section(), raw)},
              {"recovered", values_on_page(plate.section(), recovered)}};
    }
  } // namespace



  Json
  stress_lines(const Cycle &cycle, const Snapshot &state)
  {
    const PlateDiscretization &plate  = cycle.discretization();
    Json                       fields = Json::array(), lines = Json::array();
    for (const SectionField &field :
         section_fields(plate.section(),
                        Eigen::MatrixXd::Zero(plate.section().n_resultants(),
                                              1)))
      fields.push_back({{"name", field.name}, {"unit", field.unit}});
    RecoveredField recovered(plate,
                             cycle.recovery(),
                             plate.section().stiffness(),
                             state.unknowns);
    // beside edges of cells, which would belong to two of them
    const double aside = 1e-6 * cycle.result.min_cell_size;
    const double half  = std::sqrt(0.5);
    const std::pair<const char *, Ray> rays[] = {
      {"Along x", {{0., aside}, Point<2>(1., 0.)}},
      {"Along y", {{aside, 0.}, Point<2>(0., 1.)}},
      {"Along the diagonal", {{aside, 0.}, Point<2>(half, half)}}};
    for (const auto &[title, ray] : rays)
      {
        lines.push_back({{"title", title}});
        lines.back().update(stresses_along(ray, cycle, recovered, state));
      }
    return {{"fields", fields}, {"lines", lines}};
  }
} // namespace PlateImpact
